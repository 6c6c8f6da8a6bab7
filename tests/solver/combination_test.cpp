// SPDX-License-Identifier: MIT
// Compares all combinations of features with plain loops: materials, temperature, history,
// scattered strength, no-fail zones, planes, quadratures, micromoduli and breaking rules.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/composite.hpp"
#include "support/reference.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

using test::Reference;

// One bit per feature of a scene.
constexpr int mixed = 1, warm = 2, history = 4, scattered = 8, late = 16, other_family = 32;
constexpr int all = 64;

Plate torn(int what) {
  Plate plate = test::composite(
      34, 20, {(what & mixed) != 0, (what & warm) != 0, (what & history) != 0 ? 0.25 : 0.0});
  if ((what & scattered) != 0) plate.scatter = Scatter{Scatter::Kind::normal, 0.25, 0.0, 3};
  if ((what & other_family) != 0) plate.plane = Plane::strain;
  plate.cracks.push_back({{0.0, 0.35 * plate.height}, {0.3 * plate.width, 0.35 * plate.height}});
  plate.loads.tractions.push_back({Edge::top, {5e6, 40e6}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -40e6}});
  plate.no_fail.push_back(strip(plate, Edge::top, 1e-3));
  return plate;
}

Numerics numerics(int what) {
  Numerics numerics = test::numerics(0.5e-3, 1.6e-3);
  if ((what & late) != 0) numerics.breaking = Breaking::next_step;
  if ((what & other_family) != 0) {
    numerics.micromodulus = Micromodulus::conical;
    numerics.quadrature = Quadrature::centroid;
  }
  return numerics;
}

// Excludes history with late breaking: a bond that breaks in this step must not report its smallest
// stretch late.
bool makes_sense(int what) {
  return (what & late) == 0 || (what & history) == 0;
}

TEST(Combinations, BreakTheSameBondsAsTheReference) {
  for (int what = 0; what < all; ++what) {
    if (!makes_sense(what)) continue;
    SCOPED_TRACE(fmt::format("{:06b}", what));
    Simulation simulation(torn(what), numerics(what), {1});
    Reference reference(simulation);
    for (int n = 0; n < 40; ++n) {
      reference.take_heat(simulation);
      reference.step();
      simulation.step();
    }
    EXPECT_EQ(reference.differing_bonds(simulation), 0);
    EXPECT_GT(simulation.lattice().bonds.count() - simulation.state().bonds.count(), 20);
    double worst = 0.0;
    const Grid& grid = simulation.lattice().grid;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        worst =
            std::max(worst, (simulation.state().u(i, j) - reference.u(i, j).cast<double>()).norm());
    EXPECT_LT(worst, 1e-12);
  }
}

}  // namespace
}  // namespace hackle
