// SPDX-License-Identifier: MIT
#include "output/painting.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

const Grid grid{200, 80, 0.5e-3, {0.05, 0.02}};

PictureOptions zoomed(double x, double y, double half_width) {
  PictureOptions options;
  options.zoom = Zoom{{x, y}, half_width};
  return options;
}

TEST(Painting, LooksAtTheWholePlateUnlessZoomed) {
  const Window window = window_of({}, grid);
  EXPECT_EQ(window.left, 0);
  EXPECT_EQ(window.bottom, 0);
  EXPECT_EQ(window.nx, 200);
  EXPECT_EQ(window.ny, 80);
}

TEST(Painting, AZoomIsAWindowOfThePlatesShapeInWholeCells) {
  struct Case {
    double x, y, half;
    Window window;
  };
  for (const Case& c : {Case{0.05, 0.02, 0.05, {0, 0, 200, 80}},
                        {0.06, 0.02, 0.01, {100, 32, 40, 16}},
                        {0.0, 0.0, 0.01, {-20, -8, 40, 16}},
                        {0.1, 0.04, 0.1, {0, 0, 400, 160}},
                        {0.05, 0.02, 0.5e-3, {99, 40, 2, 1}}}) {
    SCOPED_TRACE(testing::Message() << c.x << " " << c.y << " " << c.half);
    const PictureOptions options = zoomed(c.x, c.y, c.half);
    EXPECT_NO_THROW(check("frame", options, grid));
    const Window window = window_of(options, grid);
    EXPECT_EQ(window.left, c.window.left);
    EXPECT_EQ(window.bottom, c.window.bottom);
    EXPECT_EQ(window.nx, c.window.nx);
    EXPECT_EQ(window.ny, c.window.ny);
  }
}

TEST(Painting, RefusesAZoomThatShowsNothing) {
  const double nan = std::nan(""), infinite = HUGE_VAL;
  for (const auto& [x, y, half] : {std::tuple{0.2, 0.02, 0.01},
                                   {0.05, -0.1, 0.01},
                                   {nan, 0.02, 0.01},
                                   {0.05, infinite, 0.01},
                                   {0.05, 0.02, 0.0},
                                   {0.05, 0.02, -0.01},
                                   {0.05, 0.02, 0.11},
                                   {0.05, 0.02, 1e-4},
                                   {0.05, 0.02, nan},
                                   {0.05, 0.02, infinite}})
    EXPECT_THROW(check("frame", zoomed(x, y, half), grid), Error) << x << " " << y << " " << half;
}

TEST(Painting, SaysWhereThePlateIs) {
  try {
    check("frame", zoomed(0.2, 0.02, 0.01), grid);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(),
                HasSubstr("frame: zoom shows nothing of the plate, its middle is {200 mm, 20 mm}"));
    EXPECT_THAT(error.what(), HasSubstr("from {0 m, 0 m} to {100 mm, 40 mm}"));
  }
}

TEST(Painting, ABarePictureHasThePixelsThatWereAskedFor) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  for (const Extent& size : {Extent{320, 64}, {1, 1}, {7, 301}}) {
    const Image image = paint(simulation, {}, size);
    EXPECT_EQ(image.width, size.width);
    EXPECT_EQ(image.height, size.height);
  }
}

TEST(Painting, TheOverlayIsAsTheOptionsHaveIt) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  EXPECT_EQ(style_of(options, simulation).title, simulation.plate().material.name);
  const Image plain = paint(simulation, options);
  options.overlay.title = "";
  options.overlay.time = options.overlay.bar = options.overlay.scale_bar = false;
  EXPECT_EQ(style_of(options, simulation).title, "");
  EXPECT_LT(paint(simulation, options).height, plain.height);
  options.overlay.load_curve = true;
  options.overlay.bar = true;
  EXPECT_GT(paint(simulation, options).height, plain.height);
}

TEST(Painting, ChartsArePaidForOnlyWhereAskedFor) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  PictureOptions options;
  EXPECT_TRUE(shot_of(options, simulation).energy.curves.empty());
  EXPECT_TRUE(shot_of(options, simulation).load_curve.curves.empty());
  options.overlay.energy = options.overlay.load_curve = true;
  EXPECT_EQ(shot_of(options, simulation).energy.curves.size(), 3U);
  EXPECT_EQ(shot_of(options, simulation).load_curve.curves.size(), 2U);
}

TEST(Painting, TheWidestPictureFits) {
  EXPECT_EQ(widest_picture({}, grid, {1281, 2000}), 1280);
  EXPECT_EQ(widest_picture({}, grid, {300, 2000}), 0);
  EXPECT_EQ(widest_picture({}, grid, {2000, 50}), 0);
  const int width = widest_picture({}, grid, {2000, 400});
  EXPECT_LE(make_layout(grid, width).height, 400);
  EXPECT_GT(make_layout(grid, width + 2).height, 400);
}

}  // namespace
}  // namespace hackle
