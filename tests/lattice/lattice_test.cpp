// SPDX-License-Identifier: MIT
#include "lattice/lattice.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

TEST(Lattice, CountsTheBondsOfARectangle) {
  // An offset (a, b) fits (nx - |a|)(ny - |b|) times.
  const Lattice lattice(test::bare_plate(200, 80), test::numerics());
  std::int64_t expected = 0;
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
    expected += (200 - std::abs(a)) * (80 - std::abs(b));
  });
  EXPECT_EQ(lattice.bonds_born(), expected);
  EXPECT_EQ(lattice.bonds.count(), expected);
}

TEST(Lattice, TractionsHaveTheExactResultant) {
  Plate plate = test::bare_plate(30, 20);
  plate.tractions.push_back({Edge::top, {3e6, 12e6}});
  plate.tractions.push_back({Edge::right, {5e6, 0.0}});
  const Lattice lattice(plate, test::numerics());
  Vec2 force(0.0, 0.0);  // N per metre of thickness: mass of a node is rho dx^2
  for (const LoadedNode& load : lattice.loads)
    force += load.acceleration * lattice.rho * lattice.grid.dx * lattice.grid.dx;
  EXPECT_NEAR(force.x(), 3e6 * plate.width + 5e6 * plate.height, 1e-6);
  EXPECT_NEAR(force.y(), 12e6 * plate.width, 1e-6);
}

TEST(Lattice, LoadedNodesAreOrderedAndDistinct) {
  Plate plate = test::bare_plate(10, 8);
  for (const Edge edge : {Edge::right, Edge::top, Edge::left, Edge::bottom})
    plate.tractions.push_back({edge, {1e6, 1e6}});
  const Lattice lattice(plate, test::numerics());
  EXPECT_EQ(lattice.loads.size(), 2U * 10U + 2U * 6U);
  for (std::size_t k = 1; k < lattice.loads.size(); ++k)
    EXPECT_LT(lattice.grid.index(lattice.loads[k - 1].i, lattice.loads[k - 1].j),
              lattice.grid.index(lattice.loads[k].i, lattice.loads[k].j));
}

TEST(Lattice, NoFailZonesCoverTheirNodesAndTheBondsThatReachIn) {
  Plate plate = test::bare_plate(20, 20);
  plate.no_fail.push_back(strip(plate, Edge::top, 1e-3));  // the two top rows
  const Lattice lattice(plate, test::numerics());
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        const bool inside = lattice.grid.contains(i + a, j + b);
        EXPECT_EQ(lattice.unbreakable.holds(lattice.grid.layout().at(i, j), bit),
                  inside && (j >= 18 || j + b >= 18));
      }
  });
}

TEST(Lattice, DegreesCountBothEndsOfEveryBond) {
  const Lattice lattice(test::bare_plate(23, 11), test::numerics());
  const auto degree = degrees(lattice.grid, lattice.family, lattice.bonds);
  EXPECT_EQ(degree[lattice.grid.index(11, 5)], 48);
  EXPECT_EQ(degree[lattice.grid.index(0, 0)], 4 + 4 + 8);  // a quarter: two half axes, eight quads
  EXPECT_EQ(std::accumulate(degree.begin(), degree.end(), std::int64_t{0}),
            2 * lattice.bonds.count());
}

TEST(Lattice, AnIsolatedNodeHasNoBonds) {
  const Lattice lattice(test::bare_plate(20, 20), test::numerics());
  BondBits bonds = lattice.bonds;
  isolate(lattice.grid, lattice.family, 7, 9, bonds);
  const auto degree = degrees(lattice.grid, lattice.family, bonds);
  EXPECT_EQ(degree[lattice.grid.index(7, 9)], 0);
  EXPECT_EQ(degree[lattice.grid.index(8, 9)], 47);
  EXPECT_EQ(lattice.bonds.count() - bonds.count(), 48);
}

TEST(Lattice, WithoutNoFailZonesNothingIsStoredForThem) {
  EXPECT_TRUE(Lattice(test::bare_plate(20, 20), test::numerics()).unbreakable.empty());
}

}  // namespace
}  // namespace hackle
