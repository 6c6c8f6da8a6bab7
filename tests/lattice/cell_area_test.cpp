// SPDX-License-Identifier: MIT
#include "lattice/cell_area.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hackle {
namespace {

// The same by the midpoint rule: n^2 points, so an error near 1/n at a rim.
CellPart sampled(int a, int b, double radius) {
  constexpr int n = 800;
  CellPart part;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vec2 point(a - 0.5 + (i + 0.5) / n, b - 0.5 + (j + 0.5) / n);
      if (point.norm() > radius) continue;
      part.area += 1.0 / (n * n);
      part.centroid += point / (n * n);
    }
  if (part.area > 0.0) part.centroid /= part.area;
  return part;
}

TEST(CellArea, IsTheAreaAndCentroidOfWhatTheCircleLeaves) {
  for (const double radius : {2.0, 3.3, 4.0, 4.5})
    for (int b = 0; b <= 5; ++b)
      for (int a = 0; a <= 5; ++a) {
        if (a + b == 0) continue;
        const CellPart exact = cell_inside_circle(a, b, radius), check = sampled(a, b, radius);
        EXPECT_NEAR(exact.area, check.area, 2e-3) << a << "," << b << " in " << radius;
        if (check.area > 0.05) {
          EXPECT_LT((exact.centroid - check.centroid).norm(), 5e-3);
        }
      }
}

TEST(CellArea, IsOneInsideAndNothingOutside) {
  EXPECT_EQ(cell_inside_circle(1, 2, 4.0).area, 1.0);
  EXPECT_EQ(cell_inside_circle(0, 3, 4.0).area, 1.0);
  EXPECT_EQ(cell_inside_circle(4, 4, 4.0).area, 0.0);
  EXPECT_EQ(cell_inside_circle(5, 0, 4.5).area, 0.0);  // touches
}

TEST(CellArea, IsTheSameForTheCellOnTheOtherSideOfTheDiagonal) {
  for (int b = 0; b <= 6; ++b)
    for (int a = b + 1; a <= 6; ++a)
      EXPECT_NEAR(cell_inside_circle(a, b, 5.2).area, cell_inside_circle(b, a, 5.2).area, 1e-13);
}

}  // namespace
}  // namespace hackle
