// SPDX-License-Identifier: MIT
#include "lattice/needs.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

// 200 x 80 nodes: a row of a NodeLayout has 240 places, and the last row 16 after it; 10 rows
// of 14 tiles.
constexpr double places = 80.0 * 240.0 + 16.0;
constexpr double tiles = 10.0 * 14.0;
constexpr double born = 2.0 * 16000.0;

double kept(const Plate& plate, const Numerics& numerics) {
  return memory_of(plate, numerics).kept;
}

TEST(Needs, MemoryIsThatOfTheArrays) {
  // u, the next u and v; 24 kept bonds in a word of lattice and state, and of the no-fail zones.
  Numerics numerics = test::numerics();
  Plate plate = test::edge_crack(0.0);
  EXPECT_EQ(kept(plate, numerics), places * (48.0 + 3.0 * 4.0) + tiles * 83.0 + born);
  plate.no_fail.clear();
  EXPECT_EQ(kept(plate, numerics), places * (48.0 + 2.0 * 4.0) + tiles * 83.0 + born);
  numerics.precision = Precision::f32;
  EXPECT_EQ(kept(plate, numerics), places * (24.0 + 2.0 * 4.0) + tiles * 43.0 + born);
  plate.material.alpha = 0.02;
  EXPECT_EQ(kept(plate, numerics), places * (40.0 + 2.0 * 4.0) + tiles * 43.0 + born);
}

TEST(Needs, CountTheWordsOfTheFamily) {
  Numerics numerics = test::numerics();
  const Plate plate = test::edge_crack(0.0);
  const double one = kept(plate, numerics);
  numerics.quadrature = Quadrature::area;  // 34 kept bonds
  EXPECT_EQ(kept(plate, numerics), one + places * 3.0 * 4.0);
}

TEST(Needs, OfInclusionsAreThoseOfAnotherMaterialOnlyWhereItIsOne) {
  const Numerics numerics = test::numerics();
  Plate plate = test::edge_crack(0.0);
  const double plain = kept(plate, numerics);
  plate.inclusions.push_back({rectangle({0.0, 0.0}, {0.01, 0.01}), test::duran50()});
  plate.inclusions.front().material.name = "the same under another name";
  EXPECT_FALSE(needs_of(plate, numerics).mixed);
  EXPECT_EQ(kept(plate, numerics), plain + 16000.0);
  plate.inclusions.front().material.E *= 2.0;
  EXPECT_TRUE(needs_of(plate, numerics).mixed);
  // Critical stretch, threshold, stiffness, inertia.
  EXPECT_EQ(kept(plate, numerics), plain + 16000.0 + places * 4.0 * 8.0);
  plate.inclusions.front().material.alpha = 0.25;
  EXPECT_EQ(kept(plate, numerics), plain + 16000.0 + places * 7.0 * 8.0);
}

TEST(Needs, OfTemperatureAreThoseOfTheAreasThatChange) {
  const Numerics numerics = test::numerics();
  Plate plate = test::edge_crack(0.0);
  const double plain = kept(plate, numerics);
  plate.loads.thermal_loads.push_back({});
  // Critical stretch, threshold, strain; the bound of tiles; per node all strain and the change.
  const double heated = plain + places * 3.0 * 8.0 + tiles * 8.0 + 16000.0 * 16.0;
  EXPECT_EQ(kept(plate, numerics), heated);
  plate.loads.thermal_loads.push_back({rectangle({0.01, 0.01}, {0.02, 0.02}), 10.0, {}});
  const double change = kept(plate, numerics) - heated;
  EXPECT_GE(change, 8.0 * 20.0 * 20.0);
  EXPECT_LE(change, 8.0 * 24.0 * 24.0);
}

TEST(Needs, OfAnAbsurdLatticeAreBeyondAnyMachine) {
  EXPECT_GT(memory_of(test::edge_crack(0.0), test::numerics(1e-300, 4e-300)).all(), 1e300);
}

}  // namespace
}  // namespace hackle
