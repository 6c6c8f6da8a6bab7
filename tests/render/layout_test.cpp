// SPDX-License-Identifier: MIT
#include "render/layout.hpp"

#include <random>

#include <gtest/gtest.h>

namespace hackle {
namespace {

Grid grid(int nx, int ny) {
  return {nx, ny, 1e-3, {0.5e-3 * nx, 0.5e-3 * ny}};
}

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

void expect_sound(const Layout& layout) {
  const Rectangle parts[] = {layout.caption, layout.plate, layout.bar, layout.scale};
  EXPECT_EQ(layout.width % 2, 0);
  EXPECT_EQ(layout.height % 2, 0);
  for (const Rectangle& part : parts) {
    EXPECT_GT(part.width, 0);
    EXPECT_GT(part.height, 0);
    EXPECT_GE(part.x, 0);
    EXPECT_GE(part.y, 0);
    EXPECT_LE(part.right(), layout.width);
    EXPECT_LE(part.bottom(), layout.height);
    for (const Rectangle& other : parts) EXPECT_EQ(overlap(part, other), &other == &part);
  }
}

TEST(Layout, IsSoundForAnyPlateAndWidth) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 3000; ++trial) {
    const int nx = std::uniform_int_distribution<int>(1, 3000)(random);
    const int ny = std::uniform_int_distribution<int>(1, 3000)(random);
    const int width = 2 * std::uniform_int_distribution<int>(160, 3840)(random);
    SCOPED_TRACE(testing::Message() << nx << " x " << ny << " at " << width);
    expect_sound(make_layout(grid(nx, ny), width));
  }
}

TEST(Layout, ThePapersPlateHasCellsOfSixPixels) {
  const Layout layout = make_layout(grid(200, 80), 1280);
  EXPECT_EQ(layout.plate.width, 1200);
  EXPECT_EQ(layout.plate.height, 480);
  EXPECT_EQ(layout.plate.x, 40);
  EXPECT_LT(layout.height, 720);
}

TEST(Layout, KeepsTheShapeOfThePlate) {
  for (const int ny : {20, 80, 400}) {
    const Layout layout = make_layout(grid(200, ny), 1280);
    const double shape = static_cast<double>(layout.plate.width) / layout.plate.height;
    EXPECT_NEAR(shape * ny / 200.0, 1.0, 0.02) << ny;
  }
}

TEST(Layout, ABarePictureIsAllPlate) {
  const Layout layout = bare_layout(321, 7);
  EXPECT_EQ(layout.plate.width, 321);
  EXPECT_EQ(layout.plate.height, 7);
  EXPECT_EQ(layout.plate.x, 0);
  EXPECT_EQ(layout.plate.y, 0);
}

TEST(Window, IsALatticeInTheSamePlace) {
  const Grid whole = grid(200, 80);
  const Grid part = hackle::part(whole, {150, -10, 20, 30});
  EXPECT_EQ(part.nx, 20);
  EXPECT_EQ(part.ny, 30);
  EXPECT_LT((part.position(0, 0) - whole.position(150, -10)).norm(), 1e-15);
  EXPECT_LT((part.position(19, 29) - whole.position(169, 19)).norm(), 1e-15);
}

TEST(Neat, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(neat_at_most(0.0171), 0.01);
  EXPECT_DOUBLE_EQ(neat_at_most(2.0), 2.0);
  EXPECT_DOUBLE_EQ(neat_at_most(4.99), 2.0);
  EXPECT_DOUBLE_EQ(neat_at_most(700.0), 500.0);
}

}  // namespace
}  // namespace hackle
