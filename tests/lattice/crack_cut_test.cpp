// SPDX-License-Identifier: MIT
#include "lattice/crack_cut.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "lattice/lattice.hpp"
#include "scene/geometry.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

Lattice cut_plate(int nx, int ny, const Crack& crack, double m = 3.0) {
  Plate plate = test::bare_plate(nx, ny);
  plate.cracks.push_back(crack);
  return Lattice(plate, test::numerics(0.5e-3, m * 0.5e-3));
}

// Positions in mm, on a 0.5 mm lattice.
Crack crack(double x0, double y0, double x1, double y1) {
  return {{x0 * 1e-3, y0 * 1e-3}, {x1 * 1e-3, y1 * 1e-3}, Born::broken};
}

bool holds(const Lattice& lattice, int i, int j, int a, int b) {
  return hackle::holds(lattice.grid, lattice.family, lattice.bonds, i, j, a, b);
}

int degree(const Lattice& lattice, int i, int j) {
  return degrees(lattice.grid, lattice.family, lattice.bonds)[lattice.grid.index(i, j)];
}

TEST(CrackCut, SeparatesTheTwoSidesAndNothingElse) {
  const Lattice lattice = cut_plate(20, 20, crack(0, 5, 10, 5));  // right through
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        const bool inside = lattice.grid.contains(i + a, j + b);
        const bool same_side = (j < 10) == (j + b < 10);
        EXPECT_EQ(holds(lattice, i, j, a, b), inside && same_side);
      }
  });
}

TEST(CrackCut, ABondThatOnlyTouchesAnEndHolds) {
  const Lattice lattice = cut_plate(20, 20, crack(0, 5, 5, 5));
  // Nodes 9 and 10 lie at 4.75 and 5.25 mm: their diagonals pass exactly through the end.
  EXPECT_TRUE(holds(lattice, 9, 9, 1, 1));
  EXPECT_FALSE(holds(lattice, 9, 9, 0, 1));
  EXPECT_TRUE(holds(lattice, 10, 9, 0, 1));
}

TEST(CrackCut, EndsThatBelongToItCutWhatTouchesThem) {
  Crack one = crack(0, 5, 5, 5);
  one.ends = CrackEnds::cut;
  const Lattice lattice = cut_plate(20, 20, one);
  EXPECT_FALSE(holds(lattice, 9, 9, 1, 1));
  EXPECT_FALSE(holds(lattice, 10, 9, -1, 1));
  EXPECT_TRUE(holds(lattice, 10, 9, 0, 1));
  one.points = {{5e-3, 5e-3}, {10e-3, 5e-3}};  // from the other side
  EXPECT_FALSE(holds(cut_plate(20, 20, one), 9, 9, 1, 1));
  one.ends = CrackEnds::open;
  EXPECT_TRUE(holds(cut_plate(20, 20, one), 9, 9, 1, 1));
}

TEST(CrackCut, ANodeOnTheCrackLosesAllItsBonds) {
  // 21 rows: row 10 lies at mid-height, 5.25 mm.
  const Lattice lattice = cut_plate(20, 21, crack(0, 5.25, 5, 5.25));
  EXPECT_EQ(degree(lattice, 5, 10), 0);
  EXPECT_GT(degree(lattice, 15, 10), 0);
}

TEST(CrackCut, BrokenCracksCountAsDamageAndAbsentOnesDoNot) {
  Crack one = crack(0, 5, 5, 5);
  const Lattice broken = cut_plate(20, 20, one);
  one.born = Born::absent;
  const Lattice absent = cut_plate(20, 20, one);
  EXPECT_EQ(broken.bonds, absent.bonds);
  const std::size_t beside = broken.grid.index(5, 10);
  EXPECT_GT(broken.initial_neighbours[beside], degree(broken, 5, 10));
  EXPECT_EQ(absent.initial_neighbours[beside], degree(absent, 5, 10));
}

TEST(CrackCut, AnInnerCornerBelongsToAPolylineAndItsEndsDoNot) {
  // The corner lies at 5 mm, where the diagonals of nodes 9 and 10 meet.
  const Lattice lattice =
      cut_plate(20, 20, {{{3e-3, 5e-3}, {5e-3, 5e-3}, {5e-3, 7e-3}}, Born::broken});
  EXPECT_FALSE(holds(lattice, 9, 9, 1, 1));
  EXPECT_FALSE(holds(lattice, 9, 10, 1, -1));
  EXPECT_TRUE(holds(lattice, 9, 13, 1, 1));  // through the end at 7 mm
  EXPECT_FALSE(holds(lattice, 9, 12, 1, 0));
}

// The polyline begins and ends where the diagonals of nodes 9 and 10 meet.
TEST(CrackCut, WhereAClosedPolylineBeginsIsACornerLikeOthers) {
  std::vector<Vec2> corners{{5e-3, 5e-3}, {8e-3, 5e-3}, {8e-3, 8e-3}, {5e-3, 8e-3}};
  for (std::size_t first = 0; first < corners.size(); ++first) {
    std::vector<Vec2> points = corners;
    std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(first));
    points.push_back(points.front());
    const Lattice lattice = cut_plate(20, 20, {points, Born::broken});
    EXPECT_FALSE(holds(lattice, 9, 9, 1, 1)) << first;
    EXPECT_FALSE(holds(lattice, 15, 15, 1, 1)) << first;
    EXPECT_FALSE(holds(lattice, 15, 10, 1, -1)) << first;
    EXPECT_FALSE(holds(lattice, 9, 16, 1, -1)) << first;
    EXPECT_TRUE(holds(lattice, 12, 12, 1, 1)) << first;
  }
}

// Two cracks of each kind, in different directions: each must cut what it cuts alone.
TEST(CrackCut, SeveralCutWhatEachOfThemCuts) {
  const std::vector<Crack> cracks{crack(1, 2, 6, 4),
                                  crack(7, 1, 5, 9),
                                  {{{2e-3, 6e-3}, {4e-3, 9e-3}, {9e-3, 8e-3}}, Born::absent},
                                  {{{8e-3, 3e-3}, {9e-3, 6e-3}}, Born::absent}};
  Plate plate = test::bare_plate(20, 20);
  plate.cracks = cracks;
  const Lattice together(plate, test::numerics(0.5e-3, 1.5e-3));
  std::vector<Lattice> alone;
  for (const Crack& one : cracks) alone.push_back(cut_plate(20, 20, one));
  together.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        if (!together.grid.contains(i + a, j + b)) continue;
        const bool held = std::ranges::all_of(
            alone, [&](const Lattice& lattice) { return holds(lattice, i, j, a, b); });
        EXPECT_EQ(holds(together, i, j, a, b), held);
      }
  });
  std::int64_t born = 0;
  for (const std::uint16_t bonds : together.initial_neighbours) born += bonds;
  plate.cracks = {cracks[2], cracks[3]};
  EXPECT_EQ(born / 2, Lattice(plate, test::numerics(0.5e-3, 1.5e-3)).bonds.count());
}

TEST(CrackCut, AClosedCircleSeparatesInsideFromOutside) {
  Crack circle;
  circle.points = arc({5e-3, 5e-3}, 3e-3, 0.0, 2.0 * std::numbers::pi);
  const Lattice lattice = cut_plate(20, 20, circle);
  const auto inside = [&](int i, int j) { return lattice.grid.from_centre(i, j).norm() < 6.0; };
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        if (!lattice.grid.contains(i + a, j + b)) continue;
        if (inside(i, j) != inside(i + a, j + b)) {
          EXPECT_FALSE(holds(lattice, i, j, a, b));
        } else if (inside(i, j)) {
          EXPECT_TRUE(holds(lattice, i, j, a, b));
        }
      }
  });
}

TEST(CrackCut, AnArcCutsWhatItsChordWouldNot) {
  Crack half;
  half.points = arc({5e-3, 5e-3}, 3e-3, 0.0, std::numbers::pi);
  const Lattice lattice = cut_plate(20, 20, half);
  EXPECT_FALSE(holds(lattice, 9, 15, 0, 1));  // at the top of it, 8 mm
  EXPECT_TRUE(holds(lattice, 9, 9, 0, 1));    // on its chord
  EXPECT_TRUE(holds(lattice, 9, 3, 0, 1));    // where the other half would be
}

// Mirror images of a random crack, about both midlines, must cut mirror images of its bonds. Half
// of the cracks end exactly on nodes and bonds.
TEST(CrackCut, CommutesWithMirrorsForAnyCrack) {
  std::mt19937 random(11);
  const int nx = 13, ny = 12;
  const double width = 0.5 * nx, height = 0.5 * ny;
  for (int trial = 0; trial < 200; ++trial) {
    const auto pick = [&](double max) {
      const double value = std::uniform_real_distribution<double>(0.0, max)(random);
      return trial % 2 == 0 ? value : std::floor(value * 4.0) / 4.0;
    };
    const double x0 = pick(width), y0 = pick(height), x1 = pick(width), y1 = pick(height);
    if (x0 == x1 && y0 == y1) continue;
    const Lattice plain = cut_plate(nx, ny, crack(x0, y0, x1, y1));
    const Lattice mirrored = cut_plate(nx, ny, crack(width - x0, y0, width - x1, y1));
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        plain.family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
          const bool held = holds(plain, i, j, a, b);
          ASSERT_EQ(held, holds(mirrored, nx - 1 - i, j, -a, b)) << trial;
          if (!plain.grid.contains(i + a, j + b)) return;
          ASSERT_EQ(held, holds(plain, i + a, j + b, -a, -b)) << trial;
        });
      }
  }
}

}  // namespace
}  // namespace hackle
