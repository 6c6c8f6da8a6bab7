// SPDX-License-Identifier: MIT
#include "base/progress.hpp"

#include <gmock/gmock.h>

namespace hackle {
namespace {

std::string shown(Talk talk, double fraction) {
  testing::internal::CaptureStderr();
  {
    Progress progress(talk);
    progress.due(0.0);
    progress.show(fraction, "step 7");
  }
  return testing::internal::GetCapturedStderr();
}

TEST(Progress, QuietIsNeverDue) {
  Progress progress(Talk::quiet);
  for (const double fraction : {0.0, 0.5, 1.0}) EXPECT_FALSE(progress.due(fraction));
}

TEST(Progress, ShortWorkShowsNothing) {
  for (const Talk talk : {Talk::plain, Talk::animated}) {
    Progress progress(talk);
    EXPECT_FALSE(progress.due(0.0));
    EXPECT_FALSE(progress.due(0.99));
  }
}

TEST(Progress, PlainLinesAreWholeLines) {
  EXPECT_THAT(shown(Talk::plain, 0.5), testing::MatchesRegex(" 50 %  step 7  .* left\n"));
}

TEST(Progress, ABarIsRedrawnInPlaceAndCleared) {
  const std::string text = shown(Talk::animated, 0.25);
  EXPECT_THAT(text, testing::HasSubstr("\r\033[K"));
  EXPECT_THAT(text, testing::HasSubstr(" 25 %"));
  EXPECT_TRUE(text.ends_with("\r\033[K"));
}

}  // namespace
}  // namespace hackle
