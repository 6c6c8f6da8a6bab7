// SPDX-License-Identifier: MIT
#include "output/painting.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// Of the edge-cracked plate at 0.5 mm.
const Grid grid{200, 80, 0.5e-3, {0.05, 0.02}};

PictureOptions zoomed(double x, double y, double half_width) {
  PictureOptions options;
  options.zoom = Zoom{{x, y}, half_width};
  return options;
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
  options.overlay.clock = options.overlay.bar = options.overlay.scale_bar = false;
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
  const Simulation simulation(test::edge_crack(12e6), test::numerics(), {1});
  EXPECT_EQ(widest_picture({}, simulation, {1281, 2000}), 1280);
  EXPECT_EQ(widest_picture({}, simulation, {300, 2000}), 0);
  EXPECT_EQ(widest_picture({}, simulation, {2000, 50}), 0);
  const int width = widest_picture({}, simulation, {2000, 400});
  EXPECT_LE(make_layout(grid, width).height, 400);
  EXPECT_GT(make_layout(grid, width + 2).height, 400);
}

TEST(Painting, OnlyAPictureByItselfIsTransparent) {
  PictureOptions options;
  EXPECT_NO_THROW(check_opaque("movie", options));
  options.background = Background::transparent;
  EXPECT_NO_THROW(check("frame", options, grid));
  EXPECT_THROW(check_opaque("movie", options), Error);
}

TEST(Painting, AShotHoldsNoMoreThanItsPictureShows) {
  const Simulation simulation(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  const std::size_t nodes = simulation.lattice().grid.nodes();
  PictureOptions options;
  EXPECT_TRUE(shot_of(options, simulation).gaps.empty());
  EXPECT_TRUE(shot_of(options, simulation).displacement.empty());
  options.field = "stress_1";
  EXPECT_EQ(shot_of(options, simulation).gaps.size(), nodes);
  options.deformed = true;
  EXPECT_EQ(shot_of(options, simulation).displacement.size(), 2 * nodes);
  EXPECT_EQ(shot_of(options, simulation).links.size(), nodes);
}

}  // namespace
}  // namespace hackle
