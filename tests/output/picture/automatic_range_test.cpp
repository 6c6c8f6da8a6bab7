// SPDX-License-Identifier: MIT
#include "output/picture/automatic_range.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "output/picture/field_choice.hpp"
#include "output/picture/painting.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

constexpr int nx = 100, ny = 10;

// Makes a state in which u_x grows along x from `first` to `last`, in spacings.
Simulation stretched(double first, double last) {
  Simulation simulation(test::bare_plate(nx, ny), test::numerics(), {1});
  simulation.restore(test::displaced(simulation, [&](const Vec2& place) {
    return Vec2(first + (last - first) * (place.x() / (nx - 1) + 0.5), 0.0);
  }));
  return simulation;
}

PictureOptions options_for(const char* field, double percentile) {
  PictureOptions options;
  options.field = field;
  options.percentile = percentile;
  return options;
}

constexpr double dx = 0.5e-3;
constexpr double one_column = 1.0 / (nx - 1);

TEST(AutomaticRange, SpansAllValuesAtHundredPercent) {
  const Ends ends = automatic_range(options_for("displacement", 100.0), stretched(0.1, 0.2));
  EXPECT_FLOAT_EQ(static_cast<float>(ends.min), static_cast<float>(0.1 * dx));
  EXPECT_FLOAT_EQ(static_cast<float>(ends.max), static_cast<float>(0.2 * dx));
}

// The values are evenly distributed, so the quantiles are known to one column and to the bins of
// the counts.
TEST(AutomaticRange, LeavesHalfOfTheRestOutOnEitherSide) {
  const Ends ends = automatic_range(options_for("displacement", 80.0), stretched(0.1, 0.2));
  const double grain = 0.2 * dx / 512 + 0.1 * dx * one_column;
  EXPECT_NEAR(ends.min, 0.11 * dx, grain);
  EXPECT_NEAR(ends.max, 0.19 * dx, grain);
}

TEST(AutomaticRange, IsSymmetricForColoursThatDiverge) {
  const Simulation simulation = stretched(-0.1, 0.3);
  const Ends own = automatic_range(options_for("displacement_x", 100.0), simulation);
  EXPECT_FLOAT_EQ(static_cast<float>(own.max), static_cast<float>(0.3 * dx));
  EXPECT_EQ(own.min, -own.max);
  PictureOptions chosen = options_for("displacement", 100.0);
  chosen.colours = "roma";
  const Ends given = automatic_range(chosen, simulation);
  EXPECT_EQ(given.min, -given.max);
  chosen.field = "displacement_x";
  chosen.colours = "viridis";
  EXPECT_FLOAT_EQ(static_cast<float>(automatic_range(chosen, simulation).min),
                  static_cast<float>(-0.1 * dx));
}

TEST(AutomaticRange, OfStrengthIsSymmetricAboutOne) {
  Plate plate = test::bare_plate(nx, ny);
  plate.scatter = Scatter{Scatter::Kind::normal, 0.1, 0.0, 3};
  const Ends ends =
      automatic_range(options_for("strength", 90.0), Simulation(plate, test::numerics(), {1}));
  EXPECT_NEAR(ends.min + ends.max, 2.0, 1e-12);
  EXPECT_LT(ends.min, 1.0);
}

TEST(AutomaticRange, OfAllStatesThatWereAdded) {
  AutomaticRange range(options_for("displacement", 100.0));
  range.add(stretched(0.1, 0.2));
  range.add(stretched(0.3, 0.4));
  EXPECT_FLOAT_EQ(static_cast<float>(range.ends().min), static_cast<float>(0.1 * dx));
  EXPECT_FLOAT_EQ(static_cast<float>(range.ends().max), static_cast<float>(0.4 * dx));
}

TEST(AutomaticRange, IsWhatSuitsTheFieldWhereAllValuesAreTheSame) {
  const Simulation simulation(test::bare_plate(nx, ny), test::numerics(), {1});
  const PictureOptions options = options_for("speed", 99.0);
  const Ends ends = automatic_range(options, simulation), usual = usual_ends(options, simulation);
  EXPECT_EQ(ends.min, usual.min);
  EXPECT_EQ(ends.max, usual.max);
}

TEST(AutomaticRange, OnALogarithmicScaleBeginsAboveZero) {
  PictureOptions options = options_for("displacement", 100.0);
  options.scale = Scale::log;
  EXPECT_GT(automatic_range(options, stretched(0.0, 0.2)).min, 0.0);
}

TEST(AutomaticRange, OfAPictureIsThatOfItsState) {
  const PictureStyle style = style_of(options_for("displacement", 100.0), stretched(0.1, 0.2));
  EXPECT_FLOAT_EQ(static_cast<float>(style.field.min), static_cast<float>(0.1 * dx));
  EXPECT_FLOAT_EQ(static_cast<float>(style.field.max), static_cast<float>(0.2 * dx));
}

TEST(AutomaticRange, ExcludesARangeAndKeepsItsBounds) {
  const Grid grid = make_grid(test::bare_plate(nx, ny), dx);
  for (const double percentile : {49.9, 100.1, std::nan("")})
    EXPECT_THROW(check("frame", options_for("speed", percentile), grid), Error);
  PictureOptions both = options_for("speed", 99.0);
  EXPECT_NO_THROW(check("frame", both, grid));
  both.range = Ends{0.0, 1.0};
  try {
    check("frame", both, grid);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("range and percentile are given"));
  }
}

}  // namespace
}  // namespace hackle
