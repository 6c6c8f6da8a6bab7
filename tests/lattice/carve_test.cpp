// SPDX-License-Identifier: MIT
#include "lattice/carve.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "lattice/lattice.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

Lattice carved(int nx, int ny, const Shape& shape) {
  Plate plate = test::bare_plate(nx, ny);
  plate.cutouts.push_back({shape, ""});
  return Lattice(plate, test::numerics(0.5e-3, 1.5e-3));
}

// Mirrors a shape: x becomes width - x, or y becomes height - y.
struct Mirror {
  int axis;
  double size;
  Vec2 operator()(Vec2 p) const {
    p[axis] = size - p[axis];
    return p;
  }
  Shape operator()(const Ellipse& s) const { return Ellipse{(*this)(s.centre), s.radii, -s.angle}; }
  Shape operator()(Polygon s) const {
    for (Vec2& p : s.points) p = (*this)(p);
    return s;
  }
  Shape operator()(const Capsule& s) const {
    return Capsule{{(*this)(s.axis.from), (*this)(s.axis.to)}, s.radius};
  }
  Shape operator()(const Bitmap& s) const {
    const Vec2 one = (*this)(s.least), other = (*this)(s.most);
    Bitmap seen{one.cwiseMin(other), one.cwiseMax(other), s.columns, s.rows, s.inside};
    for (int j = 0; j < s.rows; ++j)
      for (int i = 0; i < s.columns; ++i) {
        const int column = axis == 0 ? s.columns - 1 - i : i, row = axis == 1 ? s.rows - 1 - j : j;
        seen.inside[static_cast<std::size_t>(row * s.columns + column)] =
            s.inside[static_cast<std::size_t>(j * s.columns + i)];
      }
    return seen;
  }
};

void expect_mirrored(const Lattice& plain, const Lattice& seen, int axis, const char* what) {
  const Grid& grid = plain.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = axis == 0 ? grid.nx - 1 - i : i, l = axis == 1 ? grid.ny - 1 - j : j;
      ASSERT_EQ(plain.is_void(i, j), seen.is_void(k, l)) << what << i << ' ' << j;
      plain.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
        ASSERT_EQ(
            holds(grid, plain.family, plain.bonds, i, j, a, b),
            holds(grid, seen.family, seen.bonds, k, l, axis == 0 ? -a : a, axis == 1 ? -b : b))
            << what << i << ' ' << j << ' ' << a << ' ' << b;
      });
    }
}

// Half of the shapes have their corners and centres exactly on nodes and midway between them.
std::vector<Shape> random_shapes(std::mt19937& random, bool snapped) {
  const auto pick = [&](double most) {
    const double value = std::uniform_real_distribution<double>(0.0, most)(random);
    return 1e-3 * (snapped ? std::floor(value * 4.0) / 4.0 : value);
  };
  const auto point = [&] { return Vec2(pick(6.0), pick(6.0)); };
  std::vector<std::uint8_t> cells(12);
  for (std::uint8_t& cell : cells) cell = random() % 2;
  return {
      Ellipse{point(), {0.5e-3 + pick(2.0), 0.5e-3 + pick(2.0)}, snapped ? 0.0 : pick(3.0) * 1e3},
      Polygon{{point(), point(), point(), point(), point()}},
      Capsule{{point(), point()}, 0.25e-3 + pick(1.0)},
      Bitmap{{1e-3, 1e-3}, {5e-3, 4e-3}, 4, 3, cells}};
}

TEST(Carve, CommutesWithMirrorsForAnyShape) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 24; ++trial) {
    const int nx = 12 + trial % 2, ny = 12 + trial / 2 % 2;
    for (const Shape& shape : random_shapes(random, trial % 3 == 0)) {
      Problems problems;
      check(shape, "hole", problems);
      if (!problems.empty()) continue;
      const Lattice plain = carved(nx, ny, shape);
      for (const int axis : {0, 1}) {
        const Mirror mirror{axis, 0.5e-3 * (axis == 0 ? nx : ny)};
        const Lattice seen = carved(nx, ny, std::visit(mirror, shape));
        expect_mirrored(plain, seen, axis, kind_of(shape).c_str());
      }
    }
  }
}

TEST(Carve, WhatIsCulledWouldNotHaveBeenCut) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 12; ++trial)
    for (const Shape& shape : random_shapes(random, trial % 2 == 0)) {
      Problems problems;
      check(shape, "hole", problems);
      if (!problems.empty()) continue;
      const Lattice lattice = carved(12, 13, shape);
      const Grid& grid = lattice.grid;
      const Shape scaled = transformed(shape, grid.centre, 1.0 / grid.dx);
      for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
          lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
            if (!grid.contains(i + a, j + b)) return;
            const bool cut =
                cuts(scaled, {grid.from_centre(i, j), grid.from_centre(i + a, j + b)}, tie);
            ASSERT_EQ(holds(grid, lattice.family, lattice.bonds, i, j, a, b), !cut)
                << kind_of(shape);
          });
    }
}

TEST(Carve, ANodeOnTheRimStays) {
  // Nodes at odd multiples of 0.25 mm.
  const Lattice lattice = carved(12, 12, rectangle({1.25e-3, 1.25e-3}, {3.25e-3, 3.25e-3}));
  EXPECT_FALSE(lattice.is_void(2, 3));
  EXPECT_TRUE(lattice.is_void(3, 3));
  EXPECT_TRUE(holds(lattice.grid, lattice.family, lattice.bonds, 2, 2, 0, 1));  // along the rim
  EXPECT_FALSE(holds(lattice.grid, lattice.family, lattice.bonds, 2, 3, 1, 0));
  EXPECT_EQ(lattice.initial_neighbours[lattice.grid.index(4, 4)], 0);
}

TEST(Carve, InclusionsOfOneMaterialShareAnIndex) {
  Plate plate = test::bare_plate(12, 12);
  Material other = plate.material;
  other.E *= 2.0;
  for (int k = 0; k < 300; ++k)
    plate.inclusions.push_back({Ellipse{{1e-3 + 1e-5 * k, 2e-3}, {1e-3, 1e-3}, 0}, other});
  Problems problems;
  check(plate, problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(distinct_materials(plate).size(), 2U);
  plate.inclusions.push_back({Ellipse{{1e-3, 2e-3}, {1e-3, 1e-3}, 0}, plate.material});
  plate.inclusions.push_back({Ellipse{{1e-3, 2e-3}, {1e-3, 1e-3}, 0}, other});
  EXPECT_EQ(distinct_materials(plate).size(), 2U);  // also one after the other
  plate.inclusions.resize(300);
  for (std::size_t k = 0; k < 300; ++k) plate.inclusions[k].material.rho += static_cast<double>(k);
  check(plate, problems);
  EXPECT_EQ(problems.list().size(), 1U);
}

TEST(Carve, APlateOfWhichNothingIsLeftIsRefused) {
  EXPECT_THROW(carved(6, 6, rectangle({-1.0, -1.0}, {1.0, 1.0})), Error);
}

TEST(Carve, APolygonOfManyPointsHasItsArea) {
  Plate plate = test::bare_plate(400, 400);
  Polygon star;
  for (int k = 0; k < 200; ++k) {
    const double angle = 2.0 * 3.14159265 * k / 200.0, radius = k % 2 == 0 ? 0.096 : 0.06;
    star.points.push_back(Vec2(0.1, 0.1) + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  plate.cutouts.push_back({star, ""});
  const Grid grid = make_grid(plate, 0.5e-3);
  const auto material = materials_of_nodes(plate, grid);
  const auto removed = std::ranges::count(material, Lattice::void_node);
  const double area = 100.0 * 0.096 * 0.06 * std::sin(3.14159265 / 100.0);
  EXPECT_NEAR(static_cast<double>(removed) * 0.25e-6, area, 0.01 * area);
}

}  // namespace
}  // namespace hackle
