// SPDX-License-Identifier: MIT
#include "scene/amplitude.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Amplitude, IsOneForEverUnlessToldOtherwise) {
  EXPECT_TRUE(Amplitude().is_constant());
  for (const double t : {-1.0, 0.0, 1e-6, 1e9}) EXPECT_EQ(Amplitude().at(t), 1.0);
}

TEST(Amplitude, FollowsStraightLinesAndStaysAtItsEnds) {
  const Amplitude amplitude({{1.0, 2.0}, {3.0, 6.0}, {4.0, -2.0}});
  EXPECT_EQ(amplitude.at(0.0), 2.0);
  EXPECT_EQ(amplitude.at(2.0), 4.0);
  EXPECT_EQ(amplitude.at(3.0), 6.0);
  EXPECT_EQ(amplitude.at(3.5), 2.0);
  EXPECT_EQ(amplitude.at(99.0), -2.0);
}

TEST(Amplitude, JumpsToTheSecondValueAtTheMomentItself) {
  EXPECT_EQ(step_at(2.0).at(std::nextafter(2.0, 0.0)), 0.0);
  EXPECT_EQ(step_at(2.0).at(2.0), 1.0);
  const Amplitude amplitude = pulse(1.0, 2.0);
  EXPECT_EQ(amplitude.at(2.0), 1.0);
  EXPECT_EQ(amplitude.at(std::nextafter(3.0, 0.0)), 1.0);
  EXPECT_EQ(amplitude.at(3.0), 0.0);
  EXPECT_EQ(ramp(4.0).at(1.0), 0.25);
  EXPECT_EQ(ramp(4.0).at(5.0), 1.0);
}

TEST(Amplitude, AFunctionMustGiveFiniteNumbers) {
  const Amplitude amplitude([](double t) { return 1.0 / (t - 1.0); }, "hyperbola");
  EXPECT_EQ(amplitude.at(2.0), 1.0);
  EXPECT_EQ(amplitude.describe(), "hyperbola");
  try {
    amplitude.at(1.0);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(error.what()).find("t = 1 s"), std::string::npos) << error.what();
  }
}

TEST(Amplitude, MomentsMustAscendAndBeFinite) {
  const auto problems = [](std::vector<Vec2> points) {
    Problems found;
    check(Amplitude(std::move(points)), "traction", found);
    return found.list().size();
  };
  EXPECT_EQ(problems({{0.0, 1.0}, {0.0, 2.0}, {1.0, 3.0}}), 0U);
  EXPECT_EQ(problems({{1.0, 1.0}, {0.0, 2.0}}), 1U);
  EXPECT_EQ(problems({{0.0, std::nan("")}}), 1U);
  EXPECT_EQ(problems({{std::numeric_limits<double>::infinity(), 1.0}}), 1U);
}

// Exact for straight lines and jumps; for functions to the order of the rule.
TEST(Amplitude, HasAMeanOverATime) {
  EXPECT_DOUBLE_EQ(Amplitude().mean(1.0, 3.0), 1.0);
  EXPECT_DOUBLE_EQ(ramp(2.0).mean(0.0, 4.0), 0.75);
  EXPECT_DOUBLE_EQ(ramp(2.0).mean(0.5, 1.0), 0.375);
  EXPECT_DOUBLE_EQ(pulse(1.0, 2.0).mean(0.0, 4.0), 0.25);
  EXPECT_DOUBLE_EQ(pulse(1.0, 2.0).mean(2.5, 3.5), 0.5);
  EXPECT_DOUBLE_EQ(step_at(1.0).mean(1.0, 1.0), 1.0);  // an empty interval
  const Amplitude square([](double t) { return t * t; }, "t^2");
  EXPECT_NEAR(square.mean(1.0, 4.0), 7.0, 1e-12);
  const Amplitude wave([](double t) { return std::sin(t); }, "sin t");
  EXPECT_NEAR(wave.mean(0.0, 3.0), (1.0 - std::cos(3.0)) / 3.0, 1e-6);
}

}  // namespace
}  // namespace hackle
