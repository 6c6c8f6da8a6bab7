// SPDX-License-Identifier: MIT
// Cracks in fields that are known: those of Williams, prescribed at every node, and the strip of
// Rice (1967), whose energy per length ahead of the crack is what J must be.
#include "measure/fracture.hpp"

#include <cmath>
#include <tuple>
#include <utility>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/bond_field.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

constexpr double spacing = 0.5e-3;

// Makes a plate of `size` columns and rows with a crack from its left edge, or its lower one, to
// the middle.
Plate half_cut(int size, bool upright = false) {
  Plate plate = test::bare_plate(size, size);
  const double half = 0.5 * size * spacing;
  plate.cracks.push_back({upright ? Vec2(half, 0.0) : Vec2(0.0, half), {half, half}, Born::broken});
  return plate;
}

Numerics fine_numerics(double m) {
  Numerics numerics = test::numerics(spacing, m * spacing);
  numerics.quadrature = Quadrature::area;  // nearly the same in all directions
  return numerics;
}

// Moves the rim of a plate by Williams' singular field of these stress intensities around its
// middle, and lets the rest come to rest.
Simulation around_a_tip(Plate plate, const Vec2& ahead, const Vec2& intensity, double m) {
  const Numerics numerics = fine_numerics(m);
  const PlaneModuli moduli = plane_moduli(Lattice(plate, numerics).calibration.moduli);
  const TipFrame frame{{0.5 * plate.width, 0.5 * plate.height}, ahead};
  for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top}) {
    Support support;
    support.region = strip(plate, edge, m * spacing);
    support.value = VectorField([=](const Vec2& x) {
      const Vec2 u = intensity.x() * unit_field(FractureMode::opening, frame.local(x), moduli).u +
                     intensity.y() * unit_field(FractureMode::sliding, frame.local(x), moduli).u;
      return Vec2(u.x() * frame.ahead + u.y() * frame.normal());
    });
    plate.loads.supports.push_back(support);
  }
  Simulation simulation(plate, numerics, {2});
  simulation.relax({.tolerance = 1e-7});
  return simulation;
}

// Expects what was prescribed, to a tolerance: a crack in bonds is longer by a part of a horizon,
// which is here a thirteenth of the distance to the rim.
void expect_intensities(const Fracture& found, const Vec2& wanted, double tolerance) {
  const double within = tolerance * wanted.norm();
  EXPECT_NEAR(found.K_I().value(), wanted.x(), within);
  EXPECT_NEAR(found.K_II().value(), wanted.y(), within);
  ASSERT_TRUE(found.williams);
  EXPECT_NEAR(found.williams->K_I, wanted.x(), within);
  EXPECT_NEAR(found.williams->K_II, wanted.y(), within);
  EXPECT_NEAR(found.williams->T, 0.0, within / std::sqrt(0.01));
  EXPECT_NEAR(found.K_J(), wanted.norm(), within);
  EXPECT_LT(found.spread(), 2e-3);
}

TEST(Fracture, FindsTheIntensitiesOfBothModesAlongBothAxes) {
  for (const bool upright : {false, true}) {
    const Vec2 ahead = upright ? Vec2(0, 1) : Vec2(1, 0), intensity(3e4, -2e4);
    const Simulation simulation = around_a_tip(half_cut(80, upright), ahead, intensity, 3.0);
    const Fracture found = fracture(simulation, {.along = ahead});
    EXPECT_LT((found.frame.tip - Vec2(0.02, 0.02)).norm(), 0.2 * spacing);
    EXPECT_EQ(found.frame.ahead, ahead);
    expect_intensities(found, intensity, 0.05);
  }
}

// Askew to the lattice the faces are steps.
TEST(Fracture, FindsThemAtAnAngle) {
  const Vec2 ahead(std::cos(0.5), std::sin(0.5)), intensity(3e4, 2e4), middle(0.02, 0.02);
  Plate plate = test::bare_plate(80, 80);
  plate.cracks.push_back({middle - 0.022 * ahead, middle, Born::absent});
  const Simulation simulation = around_a_tip(plate, ahead, intensity, 3.0);
  const Fracture found = fracture(simulation, {.tip = middle});
  EXPECT_NEAR(found.frame.ahead.dot(ahead), 1.0, 1e-3);
  expect_intensities(found, intensity, 0.1);
}

// A strip of `rows` free rows between rigid grips that have moved apart, at rest.
Simulation strip_at_rest(int rows, int m, double shift) {
  const int columns = 12 * rows, all = rows + 2 * m;
  Plate plate = test::bare_plate(columns, all);
  plate.cracks.push_back(
      {{0.0, 0.5 * plate.height}, {6.0 * rows * spacing, 0.5 * plate.height}, Born::broken});
  for (const auto& [edge, sign] : {std::pair{Edge::top, 1.0}, {Edge::bottom, -1.0}}) {
    Support support;
    support.region = strip(plate, edge, m * spacing);
    support.value = Vec2(0.0, sign * shift);
    plate.loads.supports.push_back(support);
  }
  Simulation simulation(plate, test::numerics(spacing, m * spacing), {2});
  simulation.relax({.tolerance = 1e-9});
  return simulation;
}

// Returns the energy of the bonds per length of the strip, J/m2, three heights of the strip ahead
// of the tip less that far behind it.
double energy_set_free(const Simulation& simulation) {
  const Grid& grid = simulation.lattice().grid;
  const std::vector<double> energy = energy_densities(simulation);
  double sum = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    sum += (energy[grid.index(3 * grid.nx / 4, j)] - energy[grid.index(grid.nx / 4, j)]) * grid.dx;
  return sum;
}

// What is left between the two is the distance to a state that is the same all along.
TEST(Fracture, OfAStripIsTheEnergyThatItsCrackSetsFree) {
  for (const auto& [rows, m] : {std::pair{20, 3}, {20, 4}}) {
    const Simulation simulation = strip_at_rest(rows, m, 1e-7);
    const Fracture found = fracture(simulation, {});
    EXPECT_NEAR(found.J(), energy_set_free(simulation), 2e-3 * found.J());
    EXPECT_LT(found.spread(), 2e-3);
  }
}

std::string refusal_of_fracture(const Simulation& simulation, const FractureOptions& options) {
  try {
    fracture(simulation, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Fracture, RefusesWhatItCannotMeasure) {
  const Simulation whole(test::bare_plate(60, 60), test::numerics(), {1});
  EXPECT_THAT(refusal_of_fracture(whole, {}), HasSubstr("there is no crack"));
  EXPECT_THAT(refusal_of_fracture(whole, {.tip = Vec2(0.01, 0.01)}), HasSubstr("no crack ends"));
  EXPECT_THAT(refusal_of_fracture(whole, {.tip = Vec2(0.01, 0.01), .ahead = Vec2(1, 0)}),
              HasSubstr("no crack is open a horizon behind"));
  const Simulation cut(half_cut(60), test::numerics(), {1});
  EXPECT_EQ(refusal_of_fracture(cut, {}), "");
  EXPECT_THAT(refusal_of_fracture(cut, {.tip = Vec2(1.0, 0.01)}), HasSubstr("lies off the plate"));
  EXPECT_THAT(refusal_of_fracture(cut, {.radii = {5e-3, 3e-3}}),
              HasSubstr("a radius of 3 mm is too small (two horizons or more: 4 mm)"));
  const Simulation small(half_cut(24), test::numerics(), {1});
  EXPECT_THAT(refusal_of_fracture(small, {}),
              HasSubstr("1.9 horizons (a horizon of 1.52 mm or less"));
  EXPECT_FALSE(fracture_if_any(small, {}));
  EXPECT_EQ(refusal_of_fracture(small, {.radii = {4e-3}}), "");
}

}  // namespace
}  // namespace hackle
