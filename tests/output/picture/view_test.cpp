// SPDX-License-Identifier: MIT
#include "output/picture/view.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "output/picture/painting.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// 200 x 80 nodes.
Simulation plate() {
  return Simulation(test::edge_crack(12e6), test::numerics(), {1});
}

PictureOptions zoomed_at(double x, double y, double half_width) {
  PictureOptions options;
  options.zoom = Zoom{{x, y}, half_width};
  return options;
}

TEST(View, LooksAtTheWholePlateUnlessZoomed) {
  const Window window = window_of({}, plate());
  EXPECT_EQ(window.left, 0);
  EXPECT_EQ(window.bottom, 0);
  EXPECT_EQ(window.nx, 200);
  EXPECT_EQ(window.ny, 80);
}

TEST(View, AZoomIsAWindowOfThePlatesShapeInWholeCells) {
  struct Case {
    double x, y, half;
    Window window;
  };
  const Simulation simulation = plate();
  for (const Case& c : {Case{0.05, 0.02, 0.05, {0, 0, 200, 80}},
                        {0.06, 0.02, 0.01, {100, 32, 40, 16}},
                        {0.0, 0.0, 0.01, {-20, -8, 40, 16}},
                        {0.1, 0.04, 0.1, {0, 0, 400, 160}},
                        {0.05, 0.02, 1.0, {-1900, -760, 4000, 1600}},
                        {0.05, 0.02, 0.5e-3, {99, 40, 2, 1}}}) {
    SCOPED_TRACE(testing::Message() << c.x << " " << c.y << " " << c.half);
    const PictureOptions options = zoomed_at(c.x, c.y, c.half);
    Problems problems;
    check_view("frame", options, simulation.lattice().grid, problems);
    EXPECT_NO_THROW(problems.throw_if_any());
    const Window window = window_of(options, simulation);
    EXPECT_EQ(window.left, c.window.left);
    EXPECT_EQ(window.bottom, c.window.bottom);
    EXPECT_EQ(window.nx, c.window.nx);
    EXPECT_EQ(window.ny, c.window.ny);
  }
}

TEST(View, FollowingNeedsAZoom) {
  PictureOptions options;
  options.follow = Toward::right;
  Problems problems;
  check_view("movie", options, plate().lattice().grid, problems);
  try {
    problems.throw_if_any();
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("follow needs a zoom"));
  }
}

TEST(View, FollowsTheTipOfTheCrackAndKeepsItsSize) {
  const Simulation simulation = plate();
  PictureOptions options = zoomed_at(0.09, 0.02, 0.01);
  options.follow = Toward::right;
  const Window there = window_of(options, simulation);
  const Window here = followed(there, options, simulation);
  EXPECT_EQ(here.nx, there.nx);
  EXPECT_EQ(here.ny, there.ny);
  // The crack ends at 50 mm, column 100; damage of the last nodes beside it is less.
  EXPECT_NEAR(here.left + 0.5 * here.nx, 100.0, 4.0);
  EXPECT_NEAR(here.bottom + 0.5 * here.ny, 40.0, 0.5);
}

TEST(View, FollowsTheTipToWhereItIsShown) {
  Simulation simulation = plate();
  PictureOptions options = zoomed_at(0.05, 0.02, 0.01);
  options.follow = Toward::right;
  const Window at_rest = followed(window_of(options, simulation), options, simulation);
  simulation.restore(test::displaced(simulation, [](const Vec2&) { return Vec2(0.2, 0.1); }));
  options.deformed = true;
  options.magnification = 50.0;
  const Window moved = followed(window_of(options, simulation), options, simulation);
  EXPECT_EQ(moved.left - at_rest.left, 10);
  EXPECT_EQ(moved.bottom - at_rest.bottom, 5);
}

TEST(View, FollowsNothingSoFarThatCellsCannotBeCounted) {
  Simulation simulation = plate();
  simulation.restore(test::displaced(simulation, [](const Vec2&) { return Vec2(1e4, -1e4); }));
  PictureOptions options = zoomed_at(0.05, 0.02, 0.01);
  options.follow = Toward::right;
  options.deformed = true;
  options.magnification = 1e9;
  const Window window = followed(window_of(options, simulation), options, simulation);
  EXPECT_EQ(window.left, 100'000'000);
  EXPECT_EQ(window.bottom, -100'000'000);
  EXPECT_NO_THROW(paint(simulation, options));
}

TEST(View, WithoutDamageTheZoomStaysWhereItIs) {
  const Simulation simulation(test::bare_plate(40, 20), test::numerics(), {1});
  PictureOptions options = zoomed_at(0.01, 0.005, 2e-3);
  options.follow = Toward::left;
  const Window window = window_of(options, simulation);
  EXPECT_EQ(followed(window, options, simulation).left, window.left);
}

TEST(View, ThePlateAtRestIsNotMagnified) {
  EXPECT_EQ(magnification_of({}, plate()), 0.0);
}

// At the critical stretch, 0.0015, an edge of the plate 40 mm high has moved by 15 um: 20 times as
// much is 0.3 mm, the round number below 1 % of 40 mm.
TEST(View, TheUsualMagnificationIsNeatAndHasRoom) {
  PictureOptions options;
  options.deformed = true;
  const Simulation simulation = plate();
  EXPECT_EQ(magnification_of(options, simulation), 20.0);
  const Window window = window_of(options, simulation);
  EXPECT_EQ(window.left, window.bottom);
  EXPECT_NEAR(-window.left, 12.0 * 20.0 * 15.25e-6 / 0.5e-3, 1.0);
  EXPECT_EQ(window.nx, 200 - 2 * window.left);
  options.magnification = 1e6;  // at most half the plate
  EXPECT_EQ(window_of(options, simulation).bottom, -40);
}

// However it moves, no node of the plate lies outside; half of it moves up and left.
TEST(View, EnclosesThePlateAsItIsDisplaced) {
  Simulation simulation = plate();
  simulation.restore(test::displaced(
      simulation, [](const Vec2& x) { return x.y() > 0.0 ? Vec2(-0.5, 0.9) : Vec2(0, 0); }));
  for (const double rotation : {0.0, 0.4, -1.3}) {
    PictureOptions options;
    options.deformed = true;
    options.magnification = 100.0;
    options.rotation = rotation;
    const Window window = window_of(options, simulation);
    const Grid& grid = simulation.lattice().grid;
    const Camera camera(grid, window, rotation, {0, 0, 1000, 1000});
    double most = 0.0;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        const Vec2 u = 100.0 / grid.dx * simulation.displacement(i, j);
        most = std::max(most, camera.share(Vec2(i + 0.5, j + 0.5) + u).cwiseAbs().maxCoeff());
      }
    EXPECT_LE(most, 1.0) << rotation;
    EXPECT_GT(most, 0.95) << rotation << ": not much wider than needed";
  }
}

// A cross whose arms end 20 mm right and left of its centre and 10 mm above and below it.
TEST(View, FollowsInEveryDirection) {
  Plate cross = test::bare_plate(200, 80);
  cross.cracks.push_back({{30e-3, 20e-3}, {70e-3, 20e-3}});
  cross.cracks.push_back({{50e-3, 8e-3}, {50e-3, 32e-3}});
  const Simulation simulation(cross, test::numerics(), {1});
  const std::pair<Toward, Vec2> ends[] = {{Toward::right, {140, 40}},
                                          {Toward::left, {60, 40}},
                                          {Toward::up, {100, 64}},
                                          {Toward::down, {100, 16}}};
  for (const auto& [toward, cell] : ends) {
    PictureOptions options = zoomed_at(0.05, 0.02, 0.01);
    options.follow = toward;
    const Window here = followed(window_of(options, simulation), options, simulation);
    const Vec2 middle(here.left + 0.5 * here.nx, here.bottom + 0.5 * here.ny);
    EXPECT_LT((middle - cell).cwiseAbs().maxCoeff(), 4.5) << static_cast<int>(toward);
  }
}

}  // namespace
}  // namespace hackle
