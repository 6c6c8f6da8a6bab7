// SPDX-License-Identifier: MIT
#include "render/cell_mesh.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "support/displaced_lattice.hpp"

namespace hackle {
namespace {

// Returns corner `corner` of a block, in cells from the lower left corner of the lattice.
Vec2 place(const test::DisplacedLattice& of, const Blocks& blocks, const std::vector<float>& list,
           int column, int row, std::size_t corner) {
  const auto at = static_cast<std::size_t>(8 * (row * blocks.columns + column)) + 2 * corner;
  return {0.5 * of.grid.nx * (1.0 + list[at]), 0.5 * of.grid.ny * (1.0 + list[at + 1])};
}

constexpr double rounding = 1e-5;  // of single precision, for lattices of a few cells

void expect_at(const Vec2& seen, const Vec2& wanted) {
  EXPECT_NEAR(seen.x(), wanted.x(), rounding);
  EXPECT_NEAR(seen.y(), wanted.y(), rounding);
}

TEST(CellMesh, AtRestEveryCellIsItsSquare) {
  const test::DisplacedLattice lattice(5, 4);
  const Blocks blocks = blocks_of(lattice.window, lattice.window, 5, 4);
  EXPECT_EQ(blocks.size, 1);
  const auto list = lattice.corners_of(blocks);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        expect_at(place(lattice, blocks, list, i, j, k),
                  Vec2(i + static_cast<int>(k % 2), j + static_cast<int>(k / 2)));
}

TEST(CellMesh, CellsThatHangTogetherShareTheirCornersToTheBit) {
  test::DisplacedLattice lattice(6, 5);
  for (std::size_t k = 0; k < lattice.u.size(); ++k)
    lattice.u[k] = 0.1F * static_cast<float>((k * 37) % 11);
  const Blocks blocks = blocks_of(lattice.window, lattice.window, 6, 5);
  const auto list = lattice.corners_of(blocks, 3.0);
  for (int j = 0; j + 1 < 5; ++j)
    for (int i = 0; i + 1 < 6; ++i) {
      EXPECT_EQ(place(lattice, blocks, list, i, j, 3),
                place(lattice, blocks, list, i + 1, j + 1, 0));
      EXPECT_EQ(place(lattice, blocks, list, i, j, 3), place(lattice, blocks, list, i + 1, j, 2));
      EXPECT_EQ(place(lattice, blocks, list, i, j, 3), place(lattice, blocks, list, i, j + 1, 1));
    }
}

TEST(CellMesh, ARigidMotionMovesEveryCornerByIt) {
  test::DisplacedLattice lattice(4, 4);
  for (std::size_t node = 0; node < lattice.grid.nodes(); ++node) {
    lattice.u[2 * node] = 0.5F;
    lattice.u[2 * node + 1] = -0.25F;
  }
  const Blocks blocks = blocks_of(lattice.window, lattice.window, 4, 4);
  const auto list = lattice.corners_of(blocks, 2.0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      expect_at(place(lattice, blocks, list, i, j, 0), Vec2(i + 1.0, j - 0.5));
}

// The upper half moves up by one cell.
TEST(CellMesh, ThePlateOpensWhereNoBondHolds) {
  test::DisplacedLattice lattice(4, 4);
  for (int i = 0; i < 4; ++i) {
    lattice.links[lattice.grid.index(i, 1)] = Link::right;
    for (int j = 2; j < 4; ++j) lattice.u[2 * lattice.grid.index(i, j) + 1] = 1.0F;
  }
  const Blocks blocks = blocks_of(lattice.window, lattice.window, 4, 4);
  const auto list = lattice.corners_of(blocks);
  for (int i = 0; i < 4; ++i) {
    expect_at(place(lattice, blocks, list, i, 1, 2), Vec2(i, 2));
    expect_at(place(lattice, blocks, list, i, 2, 0), Vec2(i, 3));
  }
}

// One bond suffices: cells that touch only at a corner stay joined there.
TEST(CellMesh, ADiagonalBondHoldsACornerTogether) {
  test::DisplacedLattice lattice(2, 2);
  lattice.links.assign(4, 0);
  lattice.links[0] = Link::above_right;
  lattice.u[2 * lattice.grid.index(1, 1)] = 1.0F;
  const Blocks blocks = blocks_of(lattice.window, lattice.window, 2, 2);
  const auto list = lattice.corners_of(blocks);
  expect_at(place(lattice, blocks, list, 0, 0, 3), Vec2(1.5, 1));
  expect_at(place(lattice, blocks, list, 1, 1, 0), Vec2(1.5, 1));
  expect_at(place(lattice, blocks, list, 1, 0, 2), Vec2(1, 1));
}

TEST(CellMesh, ManyCellsToAPixelAreTakenTogetherAndEndAtTheLattice) {
  test::DisplacedLattice lattice(10, 7);
  const Blocks blocks = blocks_of(lattice.window, lattice.window, 3, 2);
  EXPECT_EQ(blocks.size, 3);
  EXPECT_EQ(blocks.columns, 4);
  EXPECT_EQ(blocks.rows, 3);
  const auto list = lattice.corners_of(blocks);
  expect_at(place(lattice, blocks, list, 1, 1, 0), Vec2(3, 3));
  expect_at(place(lattice, blocks, list, 3, 2, 3), Vec2(10, 7));
}

TEST(CellMesh, CellsThatAreDisplacedIntoTheWindowAreSeen) {
  test::DisplacedLattice lattice(40, 20);
  lattice.u[2 * lattice.grid.index(3, 3)] = 5.0F;
  const auto seen = [&](const Window& window, double rotation) {
    return seen_cells(window, rotation, lattice.grid, {lattice.u, lattice.links, 2.0});
  };
  const Window inside = seen({20, 8, 4, 4}, 0.0);
  EXPECT_LE(inside.left, 10);
  EXPECT_GE(inside.left, 4);  // sqrt(2) more, and a cell
  EXPECT_EQ(inside.bottom, 0);
  EXPECT_EQ(inside.ny, 20);
  // A narrow window, turned upright, shows as much of the rows as it showed of the columns.
  lattice.u.assign(lattice.u.size(), 0.0F);
  const Window turned = seen({19, 0, 2, 20}, std::numbers::pi / 2);
  EXPECT_LE(turned.left, 10);
  EXPECT_GE(turned.nx, 20);
  EXPECT_LE(turned.ny, 6);
}

TEST(CellMesh, NothingIsSeenOfAWindowBesideTheLattice) {
  const test::DisplacedLattice lattice(4, 4);
  const Window seen = seen_cells({100, 100, 4, 4}, 0.0, lattice.grid, {});
  EXPECT_EQ(seen.nx * seen.ny, 0);
}

}  // namespace
}  // namespace hackle
