// SPDX-License-Identifier: MIT
#include "study/value_text.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(ValueText, SuitsTheKind) {
  EXPECT_EQ(text_of({.number = 22.4e-6}, *quantity_named("fork.time")), "22.4 us");
  EXPECT_EQ(text_of({.place = Vec2(0.0658, 0.02)}, *quantity_named("fork.place")), "(65.8, 20) mm");
  EXPECT_EQ(text_of({.paths = {{Vec2(0, 0)}}}, *quantity_named("tip.path")), "1 path");
  EXPECT_EQ(text_of({}, *quantity_named("fork.time")), "-");
}

TEST(ValueText, TellsProgramsSI) {
  EXPECT_EQ(json_of({.number = 2.5}), 2.5);
  EXPECT_EQ(json_of({.place = Vec2(1, 2)}).dump(), "[1.0,2.0]");
  EXPECT_EQ(json_of({.paths = {{Vec2(1, 2), Vec2(3, 4)}}}).dump(), "[[[1.0,2.0],[3.0,4.0]]]");
  EXPECT_TRUE(json_of({}).is_null());
}

TEST(ValueText, NamesColumns) {
  EXPECT_EQ(column_of(*quantity_named("fork.time")), "fork.time_s");
  EXPECT_EQ(column_of(*quantity_named("tip.speed")), "tip.speed_m_per_s");
  EXPECT_EQ(column_of(*quantity_named("branches")), "branches");
}

}  // namespace
}  // namespace hackle
