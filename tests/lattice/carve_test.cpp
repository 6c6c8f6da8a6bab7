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
  Shape operator()(Ring s) const {
    s.centre = (*this)(s.centre);
    return s;
  }
  Shape operator()(const Bitmap& s) const {
    const Vec2 one = (*this)(s.min), other = (*this)(s.max);
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
  const auto pick = [&](double max) {
    const double value = std::uniform_real_distribution<double>(0.0, max)(random);
    return 1e-3 * (snapped ? std::floor(value * 4.0) / 4.0 : value);
  };
  const auto point = [&] { return Vec2(pick(6.0), pick(6.0)); };
  std::vector<std::uint8_t> cells(12);
  for (std::uint8_t& cell : cells) cell = random() % 2;
  return {
      Ellipse{point(), {0.5e-3 + pick(2.0), 0.5e-3 + pick(2.0)}, snapped ? 0.0 : pick(3.0) * 1e3},
      Polygon{{point(), point(), point(), point(), point()}},
      Capsule{{point(), point()}, 0.25e-3 + pick(1.0)},
      Ring{point(), 1.5e-3 + pick(1.5), 0.25e-3 + pick(1.0)},
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

Lattice kept(int nx, int ny, const std::vector<Shape>& areas) {
  Plate plate = test::bare_plate(nx, ny);
  plate.outlines.push_back({areas, ""});
  return Lattice(plate, test::numerics(0.5e-3, 1.5e-3));
}

TEST(Carve, OutlinesCommuteWithMirrors) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 12; ++trial) {
    const int nx = 12 + trial % 2, ny = 12 + trial / 2 % 2;
    std::vector<Shape> areas = random_shapes(random, trial % 3 == 0);
    std::erase_if(areas, [](const Shape& area) {
      Problems problems;
      check(area, "keep", problems);
      return !problems.empty();
    });
    const Lattice plain = kept(nx, ny, areas);
    for (const int axis : {0, 1}) {
      std::vector<Shape> seen;
      for (const Shape& area : areas)
        seen.push_back(std::visit(Mirror{axis, 0.5e-3 * (axis == 0 ? nx : ny)}, area));
      expect_mirrored(plain, kept(nx, ny, seen), axis, "outline");
    }
  }
}

// Bond by bond, by points along it: a bond holds when all of it is kept, its ends included.
TEST(Carve, AnOutlineKeepsTheBondsThatStayInIt) {
  const std::vector<Shape> l{Polygon{{{1e-3, 1e-3},
                                      {7e-3, 1e-3},
                                      {7e-3, 3.1e-3},
                                      {3.1e-3, 3.1e-3},
                                      {3.1e-3, 7e-3},
                                      {1e-3, 7e-3}}},
                             Ring{{5e-3, 5e-3}, 1.8e-3, 0.9e-3}};
  const Lattice lattice = kept(16, 16, l);
  const Outline outline{l, ""};
  const Grid& grid = lattice.grid;
  int cut = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      EXPECT_EQ(lattice.is_void(i, j), !covers(outline, grid.position(i, j), 1e-12));
      lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
        if (!grid.contains(i + a, j + b)) return;
        const Vec2 from = grid.position(i, j), along = grid.position(i + a, j + b) - from;
        bool stays = true;
        for (int k = 0; k <= 500; ++k)
          stays = stays && covers(outline, from + k / 500.0 * along, 1e-12);
        const bool ends = !lattice.is_void(i, j) && !lattice.is_void(i + a, j + b);
        cut += ends && !stays ? 1 : 0;
        EXPECT_EQ(holds(grid, lattice.family, lattice.bonds, i, j, a, b), stays)
            << i << ' ' << j << ' ' << a << ' ' << b;
      });
    }
  EXPECT_GT(cut, 20);
}

TEST(Carve, OfSeveralOutlinesWhatAllKeepIsLeft) {
  Plate plate = test::bare_plate(12, 12);
  plate.outlines = {{{rectangle({0, 0}, {4e-3, 6e-3})}, ""},
                    {{rectangle({2e-3, 0}, {6e-3, 6e-3})}, ""}};
  const Lattice lattice(plate, test::numerics(0.5e-3, 1.5e-3));
  for (int i = 0; i < 12; ++i) EXPECT_EQ(lattice.is_void(i, 5), i < 4 || i > 7) << i;
}

TEST(Carve, AHoleMayLeaveTheBondsThatPassThrough) {
  Plate plate = test::bare_plate(12, 12);
  const Shape hole = Ellipse{{2.75e-3, 2.75e-3}, {0.3e-3, 0.3e-3}, 0};  // around node (5, 5)
  plate.cutouts = {{hole, "", Bridging::keep}};
  const Lattice kept(plate, test::numerics(0.5e-3, 1.5e-3));
  plate.cutouts.front().bonds = Bridging::cut;
  const Lattice cut(plate, test::numerics(0.5e-3, 1.5e-3));
  const auto bridge = [](const Lattice& lattice, int a, int b) {
    return holds(lattice.grid, lattice.family, lattice.bonds, 4, 5, a, b);
  };
  for (const Lattice* lattice : {&kept, &cut}) {
    EXPECT_TRUE(lattice->is_void(5, 5));
    EXPECT_FALSE(bridge(*lattice, 1, 0));  // to the node that is gone
  }
  EXPECT_TRUE(bridge(kept, 2, 0));
  EXPECT_FALSE(bridge(cut, 2, 0));
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
