// SPDX-License-Identifier: MIT
#include "render/cell_mesh.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace hackle {
namespace {

constexpr std::uint8_t all_links = Link::right | Link::above_right | Link::above | Link::above_left;

// A lattice of cells of 1 m whose picture has 1 px a cell; `u` is the displacement of node (i, j).
struct Lattice2 {
  explicit Lattice2(int nx, int ny)
      : grid{nx, ny, 1.0, {0.5 * nx, 0.5 * ny}},
        window{0, 0, nx, ny},
        u(2 * grid.nodes()),
        links(grid.nodes(), all_links) {}

  std::vector<float> corners_of(const Blocks& blocks, double magnification = 1.0) const {
    const Camera camera(grid, window, 0.0, {0, 0, grid.nx, grid.ny});
    return corners(blocks, window, grid, {u, links, magnification}, camera);
  }

  Grid grid;
  Window window;
  std::vector<float> u;
  std::vector<std::uint8_t> links;
};

// Corner `corner` of a block, in cells from the lower left corner of the lattice.
Vec2 place(const Lattice2& of, const Blocks& blocks, const std::vector<float>& list, int column,
           int row, std::size_t corner) {
  const auto at = static_cast<std::size_t>(8 * (row * blocks.columns + column)) + 2 * corner;
  return {0.5 * of.grid.nx * (1.0 + list[at]), 0.5 * of.grid.ny * (1.0 + list[at + 1])};
}

constexpr double rounding = 1e-5;  // of single precision, for lattices of a few cells

void expect_at(const Vec2& seen, const Vec2& wanted) {
  EXPECT_NEAR(seen.x(), wanted.x(), rounding);
  EXPECT_NEAR(seen.y(), wanted.y(), rounding);
}

TEST(CellMesh, AtRestEveryCellIsItsSquare) {
  const Lattice2 lattice(5, 4);
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
  Lattice2 lattice(6, 5);
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
  Lattice2 lattice(4, 4);
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
  Lattice2 lattice(4, 4);
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

// One bond is enough: cells that touch at a corner alone hang together there.
TEST(CellMesh, ADiagonalBondHoldsACornerTogether) {
  Lattice2 lattice(2, 2);
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
  Lattice2 lattice(10, 7);
  const Blocks blocks = blocks_of(lattice.window, lattice.window, 3, 2);
  EXPECT_EQ(blocks.size, 3);
  EXPECT_EQ(blocks.columns, 4);
  EXPECT_EQ(blocks.rows, 3);
  const auto list = lattice.corners_of(blocks);
  expect_at(place(lattice, blocks, list, 1, 1, 0), Vec2(3, 3));
  expect_at(place(lattice, blocks, list, 3, 2, 3), Vec2(10, 7));
}

TEST(CellMesh, CellsThatAreDisplacedIntoTheWindowAreSeen) {
  Lattice2 lattice(40, 20);
  lattice.u[2 * lattice.grid.index(3, 3)] = 5.0F;
  const auto seen = [&](const Window& window, double rotation) {
    return seen_cells(window, rotation, lattice.grid, {lattice.u, lattice.links, 2.0});
  };
  const Window inside = seen({20, 8, 4, 4}, 0.0);
  EXPECT_LE(inside.left, 10);
  EXPECT_GE(inside.left, 4);  // sqrt(2) more, and a cell
  EXPECT_EQ(inside.bottom, 0);
  EXPECT_EQ(inside.ny, 20);
  // On end, a narrow window sees as much of the rows as it saw of the columns.
  lattice.u.assign(lattice.u.size(), 0.0F);
  const Window turned = seen({19, 0, 2, 20}, std::numbers::pi / 2);
  EXPECT_LE(turned.left, 10);
  EXPECT_GE(turned.nx, 20);
  EXPECT_LE(turned.ny, 6);
}

TEST(CellMesh, NothingIsSeenOfAWindowBesideTheLattice) {
  const Lattice2 lattice(4, 4);
  const Window seen = seen_cells({100, 100, 4, 4}, 0.0, lattice.grid, {});
  EXPECT_EQ(seen.nx * seen.ny, 0);
}

// Quadrilaterals of a lattice with a block for each cell; all have a value.
std::vector<MeshVertex> merged(const Lattice2& lattice, double tolerance,
                               std::vector<float> values = {}) {
  const Blocks blocks = blocks_of(lattice.window, lattice.window, lattice.grid.nx, lattice.grid.ny);
  if (values.empty()) values.assign(blocks.count(), 0.0F);
  return quadrilaterals(blocks, lattice.corners_of(blocks), values, {tolerance, tolerance});
}

// Every block is shown by exactly one quadrilateral.
void expect_cover(const Lattice2& lattice, const std::vector<MeshVertex>& vertices) {
  std::vector<int> shown(lattice.grid.nodes());
  for (std::size_t k = 0; k < vertices.size(); k += 4)
    for (int j = static_cast<int>(vertices[k].bottom); j <= static_cast<int>(vertices[k].top); ++j)
      for (int i = static_cast<int>(vertices[k].left); i <= static_cast<int>(vertices[k].right);
           ++i)
        ++shown[lattice.grid.index(i, j)];
  for (const int count : shown) EXPECT_EQ(count, 1);
}

TEST(Quadrilaterals, OfASmoothPlateAreFew) {
  Lattice2 lattice(70, 40);
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 70; ++i) {
      lattice.u[2 * lattice.grid.index(i, j)] = 0.01F * static_cast<float>(i);
      lattice.u[2 * lattice.grid.index(i, j) + 1] = 0.02F * static_cast<float>(j - i);
    }
  // Corners at the rim have the mean of fewer nodes, so that cells there are not flat.
  const auto vertices = merged(lattice, 1e-3);
  expect_cover(lattice, vertices);
  EXPECT_LT(vertices.size() / 4, 2U * (70 + 40));
  EXPECT_EQ(merged(Lattice2(70, 40), 1e-6).size() / 4, 3U * 2U) << "squares of 32 blocks, at rest";
}

TEST(Quadrilaterals, KeepWithinTheTolerance) {
  Lattice2 lattice(32, 32);
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
    // Their own corners are moved outwards by the tolerance.
    EXPECT_NEAR(vertices[k].x, exact[at], tolerance + 1e-6);
    EXPECT_NEAR(vertices[k].y, exact[at + 1], tolerance + 1e-6);
  }
}

TEST(Quadrilaterals, DoNotReachAcrossACrack) {
  Lattice2 lattice(16, 16);
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
  const Lattice2 lattice(8, 8);
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
