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
