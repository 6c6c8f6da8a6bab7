// SPDX-License-Identifier: MIT
#include "lattice/load_map.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

std::vector<LoadedNode> forces_of(const Plate& plate, const Lattice& lattice) {
  return forces_at(spread_forces(plate, lattice), lattice.grid, 0.0);
}

TEST(Tractions, HaveTheExactResultant) {
  Plate plate = test::bare_plate(30, 20);
  plate.loads.tractions.push_back({Edge::top, {3e6, 12e6}});
  plate.loads.tractions.push_back({Edge::right, {5e6, 0.0}});
  const Lattice lattice(plate, test::numerics());
  Vec2 force(0.0, 0.0);  // N per metre of thickness: mass of a node is rho dx^2
  for (const LoadedNode& load : forces_of(plate, lattice))
    force += load.acceleration * lattice.rho * lattice.grid.dx * lattice.grid.dx;
  EXPECT_NEAR(force.x(), 3e6 * plate.width + 5e6 * plate.height, 1e-6);
  EXPECT_NEAR(force.y(), 12e6 * plate.width, 1e-6);
}

TEST(LoadedNodes, AreOrderedAndDistinct) {
  Plate plate = test::bare_plate(10, 8);
  for (const Edge edge : {Edge::right, Edge::top, Edge::left, Edge::bottom})
    plate.loads.tractions.push_back({edge, {1e6, 1e6}});
  const Lattice lattice(plate, test::numerics());
  const auto loads = forces_of(plate, lattice);
  EXPECT_EQ(loads.size(), 2U * 10U + 2U * 6U);
  for (std::size_t k = 1; k < loads.size(); ++k)
    EXPECT_LT(lattice.grid.index(loads[k - 1].i, loads[k - 1].j),
              lattice.grid.index(loads[k].i, loads[k].j));
}

}  // namespace
}  // namespace hackle
