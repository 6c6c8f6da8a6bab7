// SPDX-License-Identifier: MIT
#include "render/overlay/chart.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

using Points = std::vector<Vec2>;

Chart chart(Points points, double until = 10.0) {
  return {"load", "Pa", until, {{"traction", "top", std::move(points)}}};
}

TEST(ChartHistory, SinglePointsBecomeACurve) {
  ChartHistory history;
  history.add(chart({{0.0, 1.0}}), 0.0);
  history.add(chart({{1.0, 4.0}}), 1.0);
  const Chart& all = history.add(chart({{3.0, 2.0}}), 3.0);
  EXPECT_EQ(all.curves[0].points, (Points{{0.0, 1.0}, {1.0, 4.0}, {3.0, 2.0}}));
}

TEST(ChartHistory, AKnownAmplitudeIsWholeFromTheStartAndDoesNotGrow) {
  const Chart ramp = chart({{0.0, 0.0}, {4.0, 1.0}, {10.0, 1.0}});
  ChartHistory history;
  for (int k = 0; k < 5; ++k)
    EXPECT_EQ(history.add(ramp, k).curves[0].points, ramp.curves[0].points);
}

// Loads exchanged during a run: the past stays, the forecast is replaced.
TEST(ChartHistory, AnExchangedAmplitudeShowsWhatItWas) {
  ChartHistory history;
  history.add(chart({{0.0, 2.0}, {10.0, 2.0}}), 0.0);
  history.add(chart({{0.0, 2.0}, {10.0, 2.0}}), 4.0);
  const Chart& all = history.add(chart({{0.0, 5.0}, {10.0, 5.0}}), 6.0);
  const Points& points = all.curves[0].points;
  EXPECT_EQ(value_at(points, 1.0), 2.0);
  EXPECT_EQ(value_at(points, 3.9), 2.0);
  EXPECT_EQ(value_at(points, 4.1), 5.0);
  EXPECT_EQ(value_at(points, 9.0), 5.0);
}

TEST(ChartHistory, TheAxisNeverShrinksAndAnEarlierTimeBeginsAnew) {
  ChartHistory history;
  history.add(chart({{0.0, 1.0}}, 10.0), 0.0);
  EXPECT_EQ(history.add(chart({{1.0, 1.0}}, 5.0), 1.0).until, 10.0);
  const Chart& anew = history.add(chart({{0.5, 3.0}}, 5.0), 0.5);
  EXPECT_EQ(anew.curves[0].points, (Points{{0.5, 3.0}}));
  EXPECT_EQ(anew.until, 5.0);
}

// Both ends are pulled alike until one is released.
TEST(ChartHistory, CurvesPartWhereTheyBeginToDiffer) {
  const auto pulled = [](double top) {
    return Chart{"load",
                 "Pa",
                 10.0,
                 {{"traction", "top", {{0.0, top}, {10.0, top}}},
                  {"traction", "bottom", {{0.0, 2.0}, {10.0, 2.0}}}}};
  };
  ChartHistory history;
  history.add(pulled(2.0), 0.0);
  EXPECT_EQ(distinct(history.add(pulled(2.0), 4.0).curves).size(), 1U);
  const auto curves = distinct(history.add(pulled(0.0), 6.0).curves);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].name, "traction top");
  EXPECT_EQ(value_at(curves[0].points, 3.0), 2.0);
  EXPECT_EQ(value_at(curves[0].points, 7.0), 0.0);
  EXPECT_EQ(curves[1].name, "traction bottom");
}

TEST(Curve, HasItsPlaceInItsNameOnlyWhereThereAreSeveral) {
  const Points one{{0.0, 1.0}}, other{{0.0, 2.0}};
  const auto curves = distinct({{"traction", "top", one},
                                {"traction", "bottom", one},
                                {"pressure", "hole", one},
                                {"pressure", "slot", other},
                                {"support", "", one}});
  std::vector<std::string> names;
  for (const NamedCurve& curve : curves) names.push_back(curve.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"traction", "pressure hole", "pressure slot", "support"}));
}

TEST(Curve, IsReadBetweenItsPointsAndIsLevelBeyond) {
  const Points jump{{1.0, 0.0}, {2.0, 0.0}, {2.0, 6.0}, {4.0, 8.0}};
  EXPECT_EQ(value_at(jump, 0.0), 0.0);
  EXPECT_EQ(value_at(jump, 1.9), 0.0);
  EXPECT_EQ(value_at(jump, 2.0), 6.0);
  EXPECT_EQ(value_at(jump, 3.0), 7.0);
  EXPECT_EQ(value_at(jump, 9.0), 8.0);
}

}  // namespace
}  // namespace hackle
