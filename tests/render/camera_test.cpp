// SPDX-License-Identifier: MIT
#include "render/camera.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hackle {
namespace {

const Grid lattice_seen{200, 80, 0.5e-3, {0.05, 0.02}};
const Rectangle frame{10, 20, 1000, 400};

void expect_at(const Vec2& seen, double x, double y) {
  EXPECT_NEAR(seen.x(), x, 1e-9);
  EXPECT_NEAR(seen.y(), y, 1e-9);
}

TEST(Camera, PutsTheCornersOfThePlateIntoThoseOfItsRectangle) {
  const Camera camera(lattice_seen, {0, 0, 200, 80}, 0.0, frame);
  expect_at(camera.pixel({0.0, 0.0}), 10, 420);
  expect_at(camera.pixel({0.1, 0.04}), 1010, 20);
  expect_at(camera.share({0, 0}), -1, -1);
  expect_at(camera.pixels_a_metre(), 1e4, 1e4);
}

TEST(Camera, TurnsCounterclockwiseAboutTheMiddleOfTheWindow) {
  const Window window = whole_window(lattice_seen, std::numbers::pi / 2, 0);
  EXPECT_EQ(window.nx, 80);
  EXPECT_EQ(window.ny, 200);
  const Camera camera(lattice_seen, window, std::numbers::pi / 2, {0, 0, 80, 200});
  expect_at(camera.pixel({0.05, 0.02}), 40, 100);
  expect_at(camera.pixel({0.1, 0.02}), 40, 0);    // the right goes to the top
  expect_at(camera.pixel({0.05, 0.04}), 0, 100);  // the top goes to the left
}

TEST(Camera, AWholeWindowHoldsEveryCornerHoweverThePlateIsTurned) {
  for (int degree = -360; degree <= 360; degree += 7) {
    const double rotation = degree * std::numbers::pi / 180;
    const Window window = whole_window(lattice_seen, rotation, 0);
    const Camera camera(lattice_seen, window, rotation, frame);
    double max = 0.0;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(200, 0), Vec2(0, 80), Vec2(200, 80)})
      max = std::max(max, camera.share(corner).cwiseAbs().maxCoeff());
    EXPECT_LE(max, 1.0 + 1e-9) << degree;
    // At most one cell too large on either side.
    EXPECT_GE(max, 1.0 - 2.0 / std::min(window.nx, window.ny)) << degree;
  }
}

TEST(Camera, AWholeWindowIsTheLatticeAndItsMargin) {
  const Window window = whole_window(lattice_seen, 0.0, 3);
  EXPECT_EQ(window.left, -3);
  EXPECT_EQ(window.bottom, -3);
  EXPECT_EQ(window.nx, 206);
  EXPECT_EQ(window.ny, 86);
}

}  // namespace
}  // namespace hackle
