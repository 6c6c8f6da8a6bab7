// SPDX-License-Identifier: MIT
// Finds the forks of bands drawn by hand, and none on straight bands of any width, in any
// direction, torn and frayed.
#include "measure/fork.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "measure/cracks.hpp"
#include "scene/geometry.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

const Grid field{200, 160, 1.0, {100.0, 80.0}};

// Draws the nodes within half a width of a line; omits some at random, none if `torn` is 0.
void draw(Nodes& nodes, const Segment& line, double width, double torn = 0.0) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int j = 0; j < field.ny; ++j)
    for (int i = 0; i < field.nx; ++i)
      if (distance(line, field.position(i, j)) <= 0.5 * width && uniform(random) >= torn)
        nodes[field.index(i, j)] = 1;
}

Vec2 away(const Vec2& from, double angle, double length) {
  return from + length * Vec2(std::cos(angle), std::sin(angle));
}

TEST(Forks, AStraightBandHasNone) {
  for (const double m : {3.0, 4.0, 6.0, 8.0, 12.0, 16.0})
    for (const double angle : {0.0, 0.2, 0.5, std::numbers::pi / 4, 1.2, std::numbers::pi / 2, 2.6})
      for (const double width : {2.0, m, 2.5 * m})
        for (const double torn : {0.0, 0.5}) {
          Nodes nodes(field.nodes());
          const Vec2 middle = field.centre;
          draw(nodes, {away(middle, angle, -60.0), away(middle, angle, 60.0)}, width, torn);
          EXPECT_TRUE(forks(nodes, Nodes(field.nodes()), field, m).empty())
              << m << " " << angle << " " << width << " " << torn;
        }
}

// In any direction of the crack, with or without an initial crack. Path lengths are exact along the
// axes and the diagonals, and elsewhere up to 8 % too long, which bends the computed middle line.
TEST(Forks, LieWhereTheMiddleLinesOfTheBranchesMeet) {
  for (const double m : {3.0, 4.0, 8.0})
    for (const double angle : {0.0, std::numbers::pi / 2, std::numbers::pi, 4.0, 0.4})
      for (const bool known : {true, false}) {
        Nodes nodes(field.nodes()), start(field.nodes());
        const Vec2 fork = field.centre, root = away(fork, angle, -60.0);
        draw(nodes, {root, fork}, 0.8 * m);
        for (const double side : {-0.45, 0.45})
          draw(nodes, {fork, away(fork, angle + side, 60.0)}, 0.8 * m);
        if (known) draw(start, {root, away(fork, angle, -40.0)}, 0.8 * m);
        const auto found = forks(nodes, start, field, m);
        ASSERT_EQ(found.size(), 1U) << m << " " << angle << " " << known;
        EXPECT_LT((found.front() - fork).norm(), 0.75 * m) << m << " " << angle << " " << known;
      }
}

TEST(Forks, NeedTwoLongBranchesThatStayApart) {
  constexpr double m = 4.0;
  const auto count = [](double length, double angle) {
    Nodes nodes(field.nodes());
    draw(nodes, {{10.0, 80.0}, {160.0, 80.0}}, m);
    draw(nodes, {{90.0, 80.0}, away({90.0, 80.0}, angle, length)}, m);
    return forks(nodes, Nodes(field.nodes()), field, m).size();
  };
  EXPECT_EQ(count(1.5 * m, 1.2), 0U) << "a hair";
  EXPECT_EQ(count(8.0 * m, 1.2), 1U);
  EXPECT_EQ(count(8.0 * m, 0.01), 0U) << "never apart";
}

TEST(Forks, BranchesThatMeetAgainAreAnIsland) {
  Nodes nodes(field.nodes()), start(field.nodes());
  const std::vector<Vec2> way{{10, 80}, {60, 80}, {80, 92}, {100, 80}, {150, 80}};
  for (std::size_t k = 0; k + 1 < way.size(); ++k) draw(nodes, {way[k], way[k + 1]}, 3.0);
  draw(nodes, {{60, 80}, {80, 68}}, 3.0);
  draw(nodes, {{80, 68}, {100, 80}}, 3.0);
  draw(start, {{10, 80}, {30, 80}}, 3.0);
  EXPECT_TRUE(forks(nodes, start, field, 3.0).empty());
}

TEST(Forks, OfSeveralAreNamedFromTheLeft) {
  constexpr double m = 3.0;
  Nodes nodes(field.nodes()), start(field.nodes());
  draw(nodes, {{30, 80}, {170, 80}}, m);
  draw(nodes, {{60, 80}, {20, 110}}, m);
  draw(nodes, {{140, 80}, {180, 50}}, m);
  draw(start, {{90, 80}, {110, 80}}, m);  // it ran in both directions
  const auto found = forks(nodes, start, field, m);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_LT((found[0] - Vec2(60, 80)).norm(), m);
  EXPECT_LT((found[1] - Vec2(140, 80)).norm(), m);
}

// Cracks as cut by the scene: straight, oblique, beside a hole, from a notch, two side by side.
TEST(Forks, CracksOfTheSceneHaveNone) {
  for (const double m : {3.0, 6.0, 16.0}) {
    Plate plate = test::bare_plate(160, 120);
    plate.cracks.push_back({{0.0, 0.03}, {0.03, 0.03}});
    plate.cracks.push_back({{0.005, 0.005}, {0.04, 0.02}});
    plate.cracks.push_back({{0.06, 0.01}, {0.06, 0.055}});
    plate.cracks.push_back({{0.0, 0.045}, {0.06, 0.045}});  // crosses it
    plate.cutouts.push_back({Ellipse{{0.03, 0.03}, {4e-3, 4e-3}}, ""});
    Numerics numerics = test::numerics();
    numerics.horizon = m * numerics.spacing;
    EXPECT_FALSE(cracks(Simulation(plate, numerics, {1})).fork) << m;
  }
}

}  // namespace
}  // namespace hackle
