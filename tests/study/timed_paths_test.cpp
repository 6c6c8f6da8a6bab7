// SPDX-License-Identifier: MIT
#include "study/timed_paths.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "study/told_runs.hpp"

namespace hackle {
namespace {

using test::told_run;

constexpr double mm = 1e-3, us = 1e-6;

// Straight on, and one that turns away at x = 60 mm at 20 us, by 1 mm for each mm.
const TimedPaths straight = timed_paths_of(told_run({{50, 20, 90, 20, 10, 50}}));
const TimedPaths turning =
    timed_paths_of(told_run({{50, 20, 60, 20, 10, 20}, {60, 20, 80, 40, 20, 40}}));

TEST(TimedPaths, ReadPlacesTimesAndTheCracksOfTheScene) {
  Outcome run = told_run({{50, 20, 90, 20, 10, 50}});
  run.told["graph"]["cracks"].push_back({{"initial", true},
                                         {"points_m", {{0.0, 0.02}, {0.05, 0.02}}},
                                         {"times_s", test::Told::array()}});
  const TimedPaths paths = timed_paths_of(run);
  ASSERT_EQ(paths.grown.size(), 1U);
  EXPECT_DOUBLE_EQ(paths.grown[0].back().place.x(), 90 * mm);
  EXPECT_DOUBLE_EQ(paths.grown[0].back().time, 50 * us);
  ASSERT_EQ(paths.initial.size(), 1U);
  EXPECT_DOUBLE_EQ(paths.rayleigh, 2000.0);
}

TEST(TimedPaths, PartWhereTheyLeaveTheTolerance) {
  // sqrt(2) mm of way for 1 mm aside: the first point beyond 2 mm is the fifth, 2.5 mm aside.
  const auto place = parting(straight, turning, {2 * mm});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->time, 22.5 * us, 1e-9);
  EXPECT_NEAR(std::abs(place->place.y() - 20 * mm) + std::abs(place->place.x() - 62.5 * mm),
              2.5 * mm, 2.6 * mm);
  EXPECT_FALSE(parting(straight, straight, {1e-6 * mm}));
}

TEST(TimedPaths, AgreeIfOneIsLateByLessThanTheLag) {
  // 2 mm at 2 km/s: 1 us.
  const TimedPaths late = timed_paths_of(told_run({{50, 20, 90, 20, 10.9, 50.9}}));
  const TimedPaths later = timed_paths_of(told_run({{50, 20, 90, 20, 18, 58}}));
  EXPECT_FALSE(parting(straight, late, {2 * mm}));
  EXPECT_TRUE(parting(straight, later, {2 * mm}));
}

TEST(TimedPaths, AreAsFarApartAsTheFarthestPoint) {
  // The straight one ends 30 mm beyond the corner, from which the turning one leaves at 45 degrees.
  EXPECT_NEAR(distance_at(1.0, straight, turning, {2 * mm}), 30 * std::sqrt(0.5) * mm, 1e-9);
  EXPECT_NEAR(distance_at(15 * us, straight, turning, {2 * mm}), 0.0, 1e-12);
}

TEST(TimedPaths, OfARunWithoutCracksAreInfinitelyFar) {
  const TimedPaths none = timed_paths_of(told_run({}));
  EXPECT_TRUE(none.empty());
  EXPECT_TRUE(std::isinf(distance_at(1.0, straight, none, {2 * mm})));
  EXPECT_EQ(distance_at(1.0, none, none, {2 * mm}), 0.0);
  EXPECT_FALSE(parting(none, none, {2 * mm}));
  EXPECT_DOUBLE_EQ(parting(straight, none, {2 * mm})->time, 10 * us);
}

}  // namespace
}  // namespace hackle
