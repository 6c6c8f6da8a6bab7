// SPDX-License-Identifier: MIT
#include "base/progress.hpp"

#include <algorithm>

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

// Characters of the bar take three bytes and one column each.
std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

TEST(Progress, ALineFitsTheTerminal) {
  const std::string detail = "step 9 000 of 14 000  12.4 us of 20 us  34 567 bonds broken";
  for (std::size_t columns = 24; columns <= 200; ++columns) {
    const std::string line = progress_line(0.62, detail, "3 s left", columns);
    EXPECT_LE(columns_of(line), columns) << line;
    EXPECT_THAT(line, testing::HasSubstr(" 62 %"));
    EXPECT_THAT(line, testing::EndsWith("  3 s left"));
  }
  EXPECT_THAT(progress_line(0.62, detail, "3 s left", 200), testing::HasSubstr(detail));
  EXPECT_THAT(progress_line(0.62, detail, "3 s left", 50),
              testing::HasSubstr("  step 9 000 of 14 000  12.4  3 s"));
  EXPECT_EQ(columns_of(progress_line(0.62, "x", "3 s left", 200)), 24U + 5 + 1 + 2 + 1 + 2 + 8);
}

TEST(Progress, ABarIsRedrawnInPlaceAndCleared) {
  const std::string text = shown(Talk::animated, 0.25);
  EXPECT_THAT(text, testing::HasSubstr("\r\033[K"));
  EXPECT_THAT(text, testing::HasSubstr(" 25 %"));
  EXPECT_TRUE(text.ends_with("\r\033[K"));
}

}  // namespace
}  // namespace hackle
