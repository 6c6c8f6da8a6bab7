// SPDX-License-Identifier: MIT
#include "study/case.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(CaseName, TellsALatticeByItsSpacingAndM) {
  EXPECT_EQ(name_of({{"simulate.spacing", "0.00025"}, {"simulate.horizon", "0.001"}}),
            "spacing 0.25 mm, m 4");
  EXPECT_EQ(name_of({{"simulate.horizon", "0.001"}}), "horizon 1 mm");
}

TEST(CaseName, LeavesWordsOfTheUserAsTheyAre) {
  EXPECT_EQ(name_of({{"load", "24MPa"}, {"simulate.spacing", "0.5mm"}}),
            "load 24MPa, spacing 0.5mm");
  EXPECT_EQ(name_of({{"simulate.precision", "f32"}, {"simulate.fused", "true"}}), "fused, f32");
  EXPECT_EQ(name_of({{"simulate.fused", "false"}}), "not fused");
  EXPECT_EQ(name_of({}), "as written");
}

TEST(CaseSettings, TheSecondWins) {
  const Settings both = joined({{"a", "1"}, {"b", "2"}}, {{"b", "3"}});
  EXPECT_EQ(both, (Settings{{"a", "1"}, {"b", "3"}}));
}

}  // namespace
}  // namespace hackle
