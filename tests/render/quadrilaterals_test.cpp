// SPDX-License-Identifier: MIT
#include "render/quadrilaterals.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/displaced_lattice.hpp"

namespace hackle {
namespace {

using test::DisplacedLattice;

// Returns the quadrilaterals of a lattice with one block per cell; all have a value.
std::vector<MeshVertex> merged(const DisplacedLattice& lattice, double tolerance,
                               std::vector<float> values = {}) {
  const Blocks blocks = blocks_of(lattice.window, lattice.window, lattice.grid.nx, lattice.grid.ny);
  if (values.empty()) values.assign(blocks.count(), 0.0F);
  return quadrilaterals(blocks, lattice.corners_of(blocks), values, {tolerance, tolerance});
}

// Checks that every block is shown by exactly one quadrilateral.
void expect_cover(const DisplacedLattice& lattice, const std::vector<MeshVertex>& vertices) {
  std::vector<int> shown(lattice.grid.nodes());
  for (std::size_t k = 0; k < vertices.size(); k += 4)
    for (int j = static_cast<int>(vertices[k].bottom); j <= static_cast<int>(vertices[k].top); ++j)
      for (int i = static_cast<int>(vertices[k].left); i <= static_cast<int>(vertices[k].right);
           ++i)
        ++shown[lattice.grid.index(i, j)];
  for (const int count : shown) EXPECT_EQ(count, 1);
}

TEST(Quadrilaterals, OfASmoothPlateAreFew) {
  DisplacedLattice lattice(70, 40);
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 70; ++i) {
      lattice.u[2 * lattice.grid.index(i, j)] = 0.01F * static_cast<float>(i);
      lattice.u[2 * lattice.grid.index(i, j) + 1] = 0.02F * static_cast<float>(j - i);
    }
  // Corners at the rim are the mean of fewer nodes, so that cells there are not flat.
  const auto vertices = merged(lattice, 1e-3);
  expect_cover(lattice, vertices);
  EXPECT_LT(vertices.size() / 4, 2U * (70 + 40));
  EXPECT_EQ(merged(DisplacedLattice(70, 40), 1e-6).size() / 4, 3U * 2U)
      << "squares of 32 blocks, at rest";
}

TEST(Quadrilaterals, KeepWithinTheTolerance) {
  DisplacedLattice lattice(32, 32);
  for (int j = 0; j < 32; ++j)
    for (int i = 0; i < 32; ++i)
      lattice.u[2 * lattice.grid.index(i, j) + 1] =
          0.5F * static_cast<float>(std::sin(0.1 * i) * std::cos(0.07 * j));
  const Blocks blocks = blocks_of(lattice.window, lattice.window, 32, 32);
  const auto exact = lattice.corners_of(blocks);
  constexpr double tolerance = 2e-3;
  const auto vertices = merged(lattice, tolerance);
  expect_cover(lattice, vertices);
  EXPECT_LT(vertices.size() / 4, lattice.grid.nodes() / 4);
  for (std::size_t k = 0; k < vertices.size(); k += 4) {
    const auto left = static_cast<std::size_t>(vertices[k].left);
    const auto bottom = static_cast<std::size_t>(vertices[k].bottom);
    const std::size_t at = 8 * (bottom * 32 + left);
    // Corners are moved outwards by the tolerance.
    EXPECT_NEAR(vertices[k].x, exact[at], tolerance + 1e-6);
    EXPECT_NEAR(vertices[k].y, exact[at + 1], tolerance + 1e-6);
  }
}

TEST(Quadrilaterals, DoNotReachAcrossACrack) {
  DisplacedLattice lattice(16, 16);
  for (int i = 0; i < 16; ++i) {
    lattice.links[lattice.grid.index(i, 9)] = Link::right;
    for (int j = 10; j < 16; ++j) lattice.u[2 * lattice.grid.index(i, j) + 1] = 0.5F;
  }
  const auto vertices = merged(lattice, 1e-3);
  expect_cover(lattice, vertices);
  for (std::size_t k = 0; k < vertices.size(); k += 4)
    EXPECT_FALSE(vertices[k].bottom <= 9 && vertices[k].top >= 10);
}

TEST(Quadrilaterals, LeaveOutWhatHasNoValue) {
  const DisplacedLattice lattice(8, 8);
  std::vector<float> values(64, 0.0F);
  values[lattice.grid.index(5, 2)] = std::numeric_limits<float>::quiet_NaN();
  const auto vertices = merged(lattice, 1e-6, values);
  float area = 0.0F;
  for (std::size_t k = 0; k < vertices.size(); k += 4) {
    const MeshVertex& one = vertices[k];
    area += (one.right - one.left + 1.0F) * (one.top - one.bottom + 1.0F);
    EXPECT_FALSE(one.left <= 5.0F && one.right >= 5.0F && one.bottom <= 2.0F && one.top >= 2.0F);
  }
  EXPECT_EQ(area, 63.0F);
}

}  // namespace
}  // namespace hackle
