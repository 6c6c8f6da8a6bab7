// SPDX-License-Identifier: MIT
#include "lattice/cell_area.hpp"

#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

namespace hackle {
namespace {

// Computes the same by the midpoint rule: n^2 points, so an error near 1/n at a rim.
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
  EXPECT_EQ(cell_inside_circle(5, 0, 4.5).area, 0.0);  // only touches
}

TEST(CellArea, OnTheAxisIsThatOfTheTextbooks) {
  // The rim passes through the cell (0, 4): a circular segment over a chord of length 1 and a
  // rectangle below it.
  const double R = 4.0, half_angle = std::asin(0.5 / R), height = std::sqrt(R * R - 0.25);
  const double segment = R * R * (half_angle - 0.5 * std::sin(2.0 * half_angle));
  const CellPart part = cell_inside_circle(0, 4, R);
  EXPECT_NEAR(part.area, segment + height - 3.5, 1e-14);
  // Moment about the axis: of the segment (2 R sin)^3/12, of the rectangle its area times its
  // midpoint.
  const double moment = 1.0 / 12.0 + 0.5 * (height * height - 3.5 * 3.5);
  EXPECT_NEAR(part.centroid.y(), moment / part.area, 1e-13);
  EXPECT_EQ(part.centroid.x(), 0.0);
}

TEST(CellArea, ExchangesWithTheAxesToTheLastBit) {
  for (int b = 0; b <= 6; ++b)
    for (int a = b + 1; a <= 6; ++a) {
      const CellPart one = cell_inside_circle(a, b, 5.2), other = cell_inside_circle(b, a, 5.2);
      EXPECT_EQ(one.area, other.area);
      EXPECT_EQ(one.centroid.x(), other.centroid.y());
      EXPECT_EQ(one.centroid.y(), other.centroid.x());
    }
}

TEST(CellArea, OfASliverHasItsCentroidInTheCell) {
  for (double excess = 1e-1; excess > 1e-13; excess *= 0.3) {
    const double corner = Vec2(3.5, 8.5).norm();
    for (const auto& [a, b, radius] : {std::tuple{0, 12, 11.5 + excess}, {4, 9, corner + excess}}) {
      const CellPart part = cell_inside_circle(a, b, radius);
      if (part.area == 0.0) continue;
      EXPECT_LE((part.centroid - Vec2(a, b)).lpNorm<Eigen::Infinity>(), 0.5) << excess;
    }
  }
}

}  // namespace
}  // namespace hackle
