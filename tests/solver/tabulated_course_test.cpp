// SPDX-License-Identifier: MIT
#include "solver/tabulated_course.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hackle {
namespace {

constexpr double dt_of_course = 1e-7;

// `count` places along a metre, in whose course `asked` counts the questions.
Course<double> course_of(std::function<double(double, double)> function, int count,
                         std::int64_t& asked) {
  Course<double> course;
  course.field = ScalarField(
      std::function<double(const Vec2&, double)>([function, &asked](const Vec2& place, double t) {
        ++asked;
        return function(place.x(), t);
      }));
  for (int k = 0; k < count; ++k) {
    course.places.emplace_back(static_cast<double>(k) / count, 0.0);
    course.divisors.push_back(2.0);
  }
  return course;
}

// A hump that travels along the places, and is wider than it goes in a block.
double hump(double x, double t) {
  const double from = (x - 0.2 - 2e4 * t) / 0.3;
  return std::exp(-from * from);
}

TEST(TabulatedCourses, HoldTheirTolerance) {
  std::int64_t asked = 0;
  TabulatedCourse<double> course(course_of(hump, 50, asked), 0.5);
  double worst = 0.0;
  for (std::int64_t step = 0; step < 256; ++step) {
    const std::vector<double> values = course.at({}, step, dt_of_course);
    ASSERT_EQ(values.size(), 50U);
    for (int k = 0; k < 50; ++k)
      worst = std::max(
          worst, std::abs(values[static_cast<std::size_t>(k)] -
                          0.5 * hump(k / 50.0, (static_cast<double>(step) + 0.5) * dt_of_course)));
  }
  EXPECT_LT(worst, TabulatedCourse<double>::max_error * 0.5);
  EXPECT_LE(asked, (4 * 17 + 1) * 50);  // every fourth step, and the first before the run
}

// A jump costs its neighbourhood only, and is exact at every step.
TEST(TabulatedCourses, TakeAJumpWhereItIs) {
  std::int64_t asked = 0;
  TabulatedCourse<double> course(
      course_of([](double, double t) { return t < 37.5 * dt_of_course ? 0.0 : 8.0; }, 3, asked),
      0.0);
  for (std::int64_t step = 0; step < 64; ++step)
    EXPECT_EQ(course.at({}, step, dt_of_course)[1], step < 38 ? 0.0 : 4.0) << step;
  EXPECT_LE(course.moments(), 16U);
}

// Blocks are counted from the clock, so it does not matter where a run begins or is cut.
TEST(TabulatedCourses, DoNotDependOnWhereTheyAreAskedFirst) {
  std::int64_t asked = 0;
  const auto sharp = [](double x, double t) { return hump(x, 5.0 * t) + x * t * 1e5; };
  TabulatedCourse<double> whole(course_of(sharp, 20, asked), 0.0);
  TabulatedCourse<double> part(course_of(sharp, 20, asked), 0.0);
  const Clock clock{3e-6, 10};
  part.tabulate(clock, 97, 200, dt_of_course);
  for (std::int64_t step = 10; step < 200; ++step) {
    const std::vector<double> values = whole.at(clock, step, dt_of_course);
    if (step >= 97) {
      EXPECT_EQ(part.at(clock, step, dt_of_course), values) << step;
    }
  }
}

// Tabulated steps are not asked for again, nor in the next part of a run.
TEST(TabulatedCourses, AskNothingTwice) {
  std::int64_t asked = 0;
  TabulatedCourse<double> course(course_of(hump, 4, asked), 0.0);
  course.tabulate({}, 0, 100, dt_of_course);
  const std::int64_t before = asked;
  EXPECT_EQ(asked, static_cast<std::int64_t>(4 * course.moments()));
  EXPECT_EQ(course.bytes(), 4 * course.moments() * sizeof(double));
  for (std::int64_t step = 0; step < 100; ++step) course.at({}, step, dt_of_course);
  course.tabulate({}, 100, 128, dt_of_course);
  course.at({}, 99, dt_of_course);
  EXPECT_EQ(asked, before);
}

TEST(TabulatedCourses, AreRefusedWhereTheyTakeTooMuch) {
  std::int64_t asked = 0;
  TabulatedCourse<double> course(
      course_of([](double x, double t) { return x * t; }, 2'000'000, asked), 0.0);
  EXPECT_THROW(course.tabulate({}, 0, 1000, dt_of_course), Error);
}

}  // namespace
}  // namespace hackle
