// SPDX-License-Identifier: MIT
// A long crack in a clamped strip: independent of its length, its energy release rate is that of
// the strained strip ahead of it, G = E e^2 H/(2 (1 - nu^2)), which must reach G0 before it grows
// (Rice 1967). E, nu and G0 are those of the lattice.
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double dx = 0.5e-3, duration = 100e-6;

struct Strip {
  int columns, rows, crack;  // in dx; rows between the grips
  int m;
};

// Makes a strip between rigid grips as deep as a horizon, next to which nothing breaks.
Plate gripped(const Strip& s, double shift) {
  Plate plate = test::bare_plate(s.columns, s.rows + 2 * s.m);
  plate.cracks.push_back({{0.0, 0.5 * plate.height}, {s.crack * dx, 0.5 * plate.height}});
  for (const auto& [edge, sign] : {std::pair{Edge::top, 1.0}, {Edge::bottom, -1.0}}) {
    Support support;
    support.region = strip(plate, edge, s.m * dx);
    support.value = Vec2(0.0, sign * shift);
    support.amplitude = ramp(duration);
    plate.loads.supports.push_back(support);
    plate.no_fail.push_back(strip(plate, edge, 2 * s.m * dx));
  }
  return plate;
}

// Returns the number of columns by which a crack has grown after loading to `share` of the critical
// strain; a straight cut takes the bonds that cross a line.
double growth(const Strip& s, double share) {
  const Numerics numerics = test::numerics(dx, s.m * dx);
  const Calibration c = Lattice(gripped(s, 0.0), numerics).calibration;
  const double height = s.rows * dx;
  const double critical =
      std::sqrt(2.0 * c.G0 * (1.0 - c.moduli.nu * c.moduli.nu) / (c.moduli.E * height));
  Simulation simulation(gripped(s, 0.5 * share * critical * height), numerics, {2});
  const QuasistaticResult result =
      simulation.load_slowly({.duration = duration, .increments = 1, .tolerance = 1e-4});
  double crossing = 0.0;
  simulation.lattice().family.for_each_bond(
      [&](int, int b, const Vec2&, double, int) { crossing += b; });
  return static_cast<double>(result.broken) / crossing;
}

// In a coarse family a crack is held between the nodes beyond Griffith's load (lattice trapping):
// it ran from 1.25 of the critical strain on with m = 3, 1.2 with m = 4, 1.15 with m = 6, 1.1 with
// m = 8, measured in steps of 0.05. Below that, only the shape of the tip adjusts.
TEST(Strip, ACrackGrowsAboveTheCriticalStrainAndNotBelow) {
  const Strip strip{96, 40, 48, 4};
  EXPECT_LT(growth(strip, 0.9), 1.0);
  EXPECT_GT(growth(strip, 1.25), 30.0);
}

TEST(Strip, ALargerFamilyMeetsTheCriticalStrainToATenth) {
  const Strip strip{110, 48, 74, 8};
  EXPECT_LT(growth(strip, 0.9), 1.0);
  EXPECT_GT(growth(strip, 1.1), 8.0);
}

}  // namespace
}  // namespace hackle
