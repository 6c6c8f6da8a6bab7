// SPDX-License-Identifier: MIT
#include "render/interpolation.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "measure/links.hpp"

namespace hackle {
namespace {

const Grid few{6, 5, 1e-3, {3e-3, 2.5e-3}};
constexpr std::uint8_t all_links = Link::right | Link::above_right | Link::above | Link::above_left;
const std::vector<std::uint8_t> whole(30, all_links);

std::vector<float> linear() {
  std::vector<float> values(few.nodes());
  for (int j = 0; j < few.ny; ++j)
    for (int i = 0; i < few.nx; ++i)
      values[few.index(i, j)] = 3.0F * static_cast<float>(i) - 2.0F * static_cast<float>(j);
  return values;
}

// Ten points a cell: inside the outermost nodes a linear field is met exactly.
TEST(Interpolation, MeetsALinearFieldBetweenNodes) {
  const std::vector<float> points = interpolated(linear(), whole, few, {0, 0, 6, 5}, 60, 50);
  for (int row = 5; row < 45; ++row)
    for (int column = 5; column < 55; ++column) {
      const double x = (column + 0.5) / 10.0 - 0.5, y = (row + 0.5) / 10.0 - 0.5;
      EXPECT_NEAR(points[static_cast<std::size_t>(60 * row + column)], 3.0 * x - 2.0 * y, 1e-5);
    }
}

TEST(Interpolation, OfAPartIsThatOfTheWhole) {
  const auto part = interpolated(linear(), whole, few, {2, 1, 3, 2}, 30, 20);
  const auto all = interpolated(linear(), whole, few, {0, 0, 6, 5}, 60, 50);
  for (std::size_t row = 0; row < 20; ++row)
    for (std::size_t column = 0; column < 30; ++column)
      EXPECT_NEAR(part[30 * row + column], all[60 * (row + 10) + column + 20], 1e-5);
}

// Rows 0 and 1 are cut from rows 2 to 4: their values meet along the sides of the cells.
TEST(Interpolation, IsSharpAtACrack) {
  std::vector<float> values(few.nodes(), 0.0F);
  std::vector<std::uint8_t> cut = whole;
  for (int i = 0; i < few.nx; ++i) {
    cut[few.index(i, 1)] = Link::right;
    for (int j = 2; j < few.ny; ++j) values[few.index(i, j)] = 1.0F;
  }
  const std::vector<float> points = interpolated(values, cut, few, {0, 0, 6, 5}, 60, 50);
  for (int row = 0; row < 50; ++row)
    for (int column = 0; column < 60; ++column)
      EXPECT_EQ(points[static_cast<std::size_t>(60 * row + column)], row < 20 ? 0.0F : 1.0F) << row;
}

TEST(Interpolation, EndsWhereTheMaterialEnds) {
  std::vector<float> values = linear();
  values[few.index(3, 2)] = std::nanf("");
  const std::vector<float> points = interpolated(values, whole, few, {-1, 0, 8, 5}, 80, 50);
  for (int row = 0; row < 50; ++row)
    for (int column = 0; column < 80; ++column) {
      const bool is_void = column >= 40 && column < 50 && row >= 20 && row < 30;
      const bool beyond = column < 10 || column >= 70;
      EXPECT_EQ(std::isnan(points[static_cast<std::size_t>(80 * row + column)]), is_void || beyond)
          << column << ' ' << row;
    }
}

}  // namespace
}  // namespace hackle
