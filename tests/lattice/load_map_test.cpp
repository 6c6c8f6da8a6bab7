// SPDX-License-Identifier: MIT
#include "lattice/load_map.hpp"

#include <gtest/gtest.h>

#include "scene/notch.hpp"
#include "support/composite.hpp"

namespace hackle {
namespace {

std::vector<LoadedNode> forces_of(const Plate& plate, const Lattice& lattice) {
  std::vector<LoadedNode> sum;
  for (SpreadForce& force : spread_forces(plate, lattice)) {
    for (LoadedNode& node : force.nodes) node.acceleration *= force.amplitude.at(0.0);
    sum = sum_of(sum, force.nodes, lattice.grid);
  }
  return sum;
}

TEST(Tractions, HaveTheExactResultant) {
  Plate plate = test::bare_plate(30, 20);
  plate.loads.tractions.push_back({Edge::top, {3e6, 12e6}});
  plate.loads.tractions.push_back({Edge::right, {5e6, 0.0}});
  const Lattice lattice(plate, test::numerics());
  Vec2 force(0.0, 0.0);  // N per metre of thickness: mass of a node is rho dx^2
  for (const LoadedNode& load : forces_of(plate, lattice))
    force += load.acceleration * lattice.rho * lattice.grid.dx * lattice.grid.dx;
  EXPECT_NEAR(force.x(), 3e6 * plate.width + 5e6 * plate.height, 1e-6);
  EXPECT_NEAR(force.y(), 12e6 * plate.width, 1e-6);
}

TEST(LoadedNodes, AreOrderedAndDistinct) {
  Plate plate = test::bare_plate(10, 8);
  for (const Edge edge : {Edge::right, Edge::top, Edge::left, Edge::bottom})
    plate.loads.tractions.push_back({edge, {1e6, 1e6}});
  const Lattice lattice(plate, test::numerics());
  const auto loads = forces_of(plate, lattice);
  EXPECT_EQ(loads.size(), 2U * 10U + 2U * 6U);
  for (std::size_t k = 1; k < loads.size(); ++k)
    EXPECT_LT(lattice.grid.index(loads[k - 1].i, loads[k - 1].j),
              lattice.grid.index(loads[k].i, loads[k].j));
}

// N per metre of thickness: mass of a node is rho dx^2.
Vec2 resultant(const std::vector<LoadedNode>& forces, const Lattice& lattice) {
  Vec2 force(0.0, 0.0);
  for (const LoadedNode& load : forces)
    force += load.inertia * lattice.rho * load.acceleration * lattice.grid.dx * lattice.grid.dx;
  return force;
}

TEST(Tractions, InALayerHaveTheSameResultant) {
  for (const double depth : {0.0, 0.2e-3, 0.5e-3, 1.7e-3, 4e-3, 1.0}) {
    Plate plate = test::bare_plate(30, 20);
    plate.loads.tractions.push_back({Edge::left, {7e6, 2e6}, depth, {}});
    const Lattice lattice(plate, test::numerics());
    const Vec2 force = resultant(forces_of(plate, lattice), lattice);
    EXPECT_NEAR(force.x(), 7e6 * plate.height, 1e-6) << depth;
    EXPECT_NEAR(force.y(), 2e6 * plate.height, 1e-6) << depth;
  }
}

TEST(Tractions, MayDependOnPlace) {
  Plate plate = test::bare_plate(30, 20);
  const auto linear = [](const Vec2& place) { return Vec2(0.0, 1e9 * place.x()); };
  plate.loads.tractions.push_back({Edge::top, VectorField(linear), 0.0, {}});
  const Lattice lattice(plate, test::numerics());
  // The midpoint rule is exact for a straight line.
  EXPECT_NEAR(resultant(forces_of(plate, lattice), lattice).y(), 0.5e9 * plate.width * plate.width,
              1e-6);
}

TEST(Tractions, PullOnlyWhereThereIsAnEdge) {
  Plate plate = test::bare_plate(30, 20);
  plate.cutouts.push_back({rectangle({2e-3, 8e-3}, {7e-3, 12e-3}), ""});  // 10 columns of 30
  plate.loads.tractions.push_back({Edge::top, {0.0, 12e6}});
  const Lattice lattice(plate, test::numerics());
  EXPECT_NEAR(resultant(forces_of(plate, lattice), lattice).y(), 12e6 * 20 * 0.5e-3, 1e-6);
}

TEST(Pressures, HaveNoResultantOnAClosedRimAndTheRightOneOnHalfOfIt) {
  Plate plate = test::bare_plate(40, 40);
  plate.cutouts.push_back({Ellipse{{10e-3, 10e-3}, {4e-3, 4e-3}, 0.0}, "bore"});
  plate.loads.pressures.push_back({"bore", 3e6, {}});
  const Lattice lattice(plate, test::numerics());
  const auto forces = forces_of(plate, lattice);
  EXPECT_NEAR(resultant(forces, lattice).norm(), 0.0, 1e-6);
  std::vector<LoadedNode> upper;
  for (const LoadedNode& node : forces)
    if (node.j >= 20) upper.push_back(node);
  // The projected width of the hole, to one cell on either side.
  EXPECT_NEAR(resultant(upper, lattice).y(), 3e6 * 8e-3, 3e6 * 2 * 0.5e-3);
  EXPECT_GT(resultant(upper, lattice).y(), 0.0);
}

TEST(BodyForces, WeighTheMaterialOfTheirArea) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.body_forces.push_back({rectangle({0, 0}, {10e-3, 10e-3}), {0.0, -5e4}, {}});
  const Lattice lattice(plate, test::numerics());
  EXPECT_NEAR(resultant(forces_of(plate, lattice), lattice).y(), -5e4 * 10e-3 * 10e-3, 1e-9);
}

TEST(BodyForces, OfAFunctionThatGivesNoNumberAreRefusedAndThePlaceIsNamed) {
  Plate plate = test::bare_plate(40, 20);
  const auto hole = [](const Vec2& place) { return Vec2(0.0, 1.0 / (place.x() - 5.25e-3)); };
  plate.loads.body_forces.push_back({{}, VectorField(hole), {}});
  const Lattice lattice(plate, test::numerics());
  try {
    spread_forces(plate, lattice);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("x = 5.25 mm"), std::string::npos) << error.what();
  }
}

TEST(Loads, ThatFindNoNodeAreRefused) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.supports.push_back({rectangle({1e-4, 1e-4}, {1.5e-4, 1.5e-4})});
  const Lattice lattice(plate, test::numerics());
  EXPECT_THROW(spread_supports(plate, lattice), Error);
}

TEST(Heat, IsTheExpansionOfTheMaterialOfEveryNode) {
  Plate plate = test::bare_plate(10, 8);  // 5 x 4 mm
  plate.material.alphaT = 4e-6;
  Material stiff = plate.material, inert = plate.material;
  stiff.alphaT = 12e-6;
  inert.alphaT = 0.0;
  plate.inclusions.push_back({rectangle({0.0, 0.0}, {1e-3, 4e-3}), stiff});
  plate.inclusions.push_back({rectangle({4e-3, 0.0}, {5e-3, 4e-3}), inert});
  plate.cutouts.push_back({rectangle({2e-3, 1e-3}, {3e-3, 2e-3}), ""});
  plate.loads.thermal_loads.push_back({rectangle({0.0, 0.0}, {5e-3, 2e-3}),
                                       ScalarField([](const Vec2& x) { return 1e6 * x.x(); }),
                                       ramp(1e-6)});
  const Lattice lattice(plate, test::numerics());
  const std::vector<SpreadHeat> heat = spread_heat(plate, lattice);
  ASSERT_EQ(heat.size(), 1U);
  const NodeRange& range = heat.front().range;
  std::size_t heated = 0;
  for (int j = range.first_j; j <= range.last_j; ++j)
    for (int i = range.first_i; i <= range.last_i; ++i) {
      const double strain = heat.front().strain.at(range.index(i, j));
      if (strain == 0.0) continue;
      ++heated;
      EXPECT_LT(j, 4);
      EXPECT_LT(i, 8);
      const double alphaT = i < 2 ? 12e-6 : 4e-6;
      EXPECT_NEAR(strain, alphaT * 1e6 * lattice.grid.position(i, j).x(), 1e-15);
    }
  EXPECT_EQ(heated, 8U * 4U - 2U * 2U);
  EXPECT_EQ(heat.front().amplitude.at(0.5e-6), 0.5);
}

TEST(Pressures, ActAtTheRimsOfTheirNameAlone) {
  Plate plate = test::bare_plate(80, 40);  // 40 x 20 mm
  const Vec2 centres[] = {{6e-3, 10e-3}, {16e-3, 10e-3}, {26e-3, 10e-3}};
  const char* const names[] = {"left", "right", ""};
  for (int k = 0; k < 3; ++k)
    plate.cutouts.push_back({Ellipse{centres[k], {2e-3, 2e-3}, 0.0}, names[k]});
  plate.cutouts.push_back(
      {shape_of({{40e-3, 10e-3}, 4e-3, 2e-3, Notch::Kind::slot, 0.0}, plate), "notch"});
  plate.loads.pressures.push_back({"right", 3e6, {}});
  const Lattice lattice(plate, test::numerics());
  const auto forces = forces_of(plate, lattice);
  EXPECT_GE(forces.size(), 20U);
  for (const LoadedNode& node : forces) {
    const Vec2 out = lattice.grid.position(node.i, node.j) - centres[1];
    EXPECT_LT(out.norm(), 2e-3 + lattice.grid.dx);
    EXPECT_GT(out.dot(node.acceleration), 0.0);  // into the material
  }
}

TEST(Pressures, ActAtEveryRimOfTheirName) {
  Plate plate = test::bare_plate(80, 40);
  const Vec2 centres[] = {{10e-3, 10e-3}, {30e-3, 10e-3}};
  for (const Vec2& centre : centres)
    plate.cutouts.push_back({Ellipse{centre, {2e-3, 2e-3}, 0.0}, "pair"});
  plate.loads.pressures.push_back({"pair", 3e6, {}});
  const Lattice lattice(plate, test::numerics());
  int left = 0, right = 0;
  for (const LoadedNode& node : forces_of(plate, lattice)) (node.i < 40 ? left : right) += 1;
  EXPECT_GT(left, 20);
  EXPECT_EQ(left, right);
}

// The force missing in a notch is the force on its mouth.
TEST(Pressures, InANotchPushThePlateAwayFromItsMouth) {
  const double pressure = 3e6, depth = 4e-3, width = 2e-3;
  const std::pair<Vec2, Vec2> mouths[] = {{{0.0, 10e-3}, {1, 0}},
                                          {{20e-3, 10e-3}, {-1, 0}},
                                          {{10e-3, 0.0}, {0, 1}},
                                          {{10e-3, 20e-3}, {0, -1}}};
  for (const auto& [at, inward] : mouths) {
    Plate plate = test::bare_plate(40, 40);
    plate.cutouts.push_back({shape_of({at, depth, width, Notch::Kind::slot, 0.0}, plate), "n"});
    plate.loads.pressures.push_back({"n", pressure, {}});
    const Lattice lattice(plate, test::numerics());
    const Vec2 force = resultant(forces_of(plate, lattice), lattice);
    EXPECT_NEAR((force - pressure * width * inward).norm(), 0.0, 1e-9 * pressure * width);
  }
}

// A glass plate with a bar of steel down its middle, from edge to edge, and another of resin.
struct Bars {
  Bars() {
    plate.inclusions.push_back({rectangle({5e-3, 0.0}, {8e-3, 10e-3}), test::steel()});
    plate.inclusions.push_back({rectangle({11e-3, 0.0}, {13e-3, 10e-3}), test::resin()});
  }
  // Computed from the numbers above, not from the lattice.
  static double density(double x) {
    return x > 5e-3 && x < 8e-3 ? 7850.0 : x > 11e-3 && x < 13e-3 ? 1200.0 : 2235.0;
  }
  Plate plate = test::bare_plate(30, 20);  // 15 x 10 mm
};

// Expects the same force per volume, `wanted`, from the acceleration of every loaded node.
void expect_force(const Plate& plate, const Vec2& wanted, std::size_t nodes) {
  const Lattice lattice(plate, test::numerics());
  const auto forces = forces_of(plate, lattice);
  EXPECT_EQ(forces.size(), nodes);
  for (const LoadedNode& node : forces) {
    const double rho = Bars::density(lattice.grid.position(node.i, node.j).x());
    EXPECT_NEAR(node.inertia, rho / 2235.0, 1e-12);
    EXPECT_NEAR((node.acceleration * rho - wanted).norm(), 0.0, 1e-9 * wanted.norm());
  }
}

TEST(Loads, AccelerateEveryMaterialByItsOwnDensity) {
  const double dx = 0.5e-3;
  for (const Edge edge : {Edge::bottom, Edge::top}) {
    Bars bars;
    bars.plate.loads.tractions.push_back({edge, {3e6, -7e6}});
    expect_force(bars.plate, Vec2(3e6, -7e6) / dx, 30);
    bars.plate.loads.tractions.back().depth = 2e-3;
    expect_force(bars.plate, Vec2(3e6, -7e6) / (4 * dx), 120);
  }
  Bars pulled;
  pulled.plate.loads.body_forces.push_back({{}, {1e6, 2e6}, {}});
  expect_force(pulled.plate, {1e6, 2e6}, 600);
  Bars pressed;  // the lower face of a slot that crosses all of them: 28 columns
  pressed.plate.cutouts.push_back({rectangle({0.5e-3, 5e-3}, {14.5e-3, 10e-3}), "top"});
  pressed.plate.loads.pressures.push_back({"top", 4e6, {}});
  const Lattice lattice(pressed.plate, test::numerics());
  int found = 0;
  for (const LoadedNode& node : forces_of(pressed.plate, lattice)) {
    if (node.j != 9) continue;
    const double rho = Bars::density(lattice.grid.position(node.i, node.j).x());
    EXPECT_NEAR((node.acceleration * rho - Vec2(0.0, -4e6 / dx)).norm(), 0.0, 1e-9 * 4e6 / dx);
    ++found;
  }
  EXPECT_EQ(found, 28);
}

// A disc that touches all four edges of its rectangle: seen along an axis it is as wide as the
// rectangle, and a pressure all around has no resultant.
TEST(Pressures, ActOnAllOfAnOutline) {
  Plate plate = test::bare_plate(40, 40);
  plate.outlines = {{{Ellipse{{0.01, 0.01}, {0.01, 0.01}, 0.0}}, "rim"}};
  plate.loads.pressures.push_back({"rim", 3e6, {}});
  const Lattice lattice(plate, test::numerics());
  Vec2 sum(0.0, 0.0), one_way(0.0, 0.0);
  for (const LoadedNode& load : forces_of(plate, lattice)) {
    const Vec2 force =
        load.acceleration * lattice.rho * lattice.grid.dx * lattice.grid.dx;  // N per metre
    sum += force;
    one_way += force.cwiseMax(0.0);
  }
  EXPECT_NEAR(sum.norm(), 0.0, 1e-6);
  EXPECT_NEAR(one_way.x(), 3e6 * plate.height, 1e-6);
  EXPECT_NEAR(one_way.y(), 3e6 * plate.width, 1e-6);
}

TEST(Tractions, ActAtTheEdgeOfTheirName) {
  const double depth = 1.5e-3;
  for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top}) {
    Plate plate = test::bare_plate(30, 20);
    plate.loads.tractions.push_back({edge, {5e6, 2e6}, depth, {}});
    const Lattice lattice(plate, test::numerics());
    const std::vector<LoadedNode> forces = forces_of(plate, lattice);
    const int length = edge == Edge::left || edge == Edge::right ? 20 : 30;
    ASSERT_EQ(forces.size(), 3U * length) << name_of(edge);  // three lines of nodes of 0.5 mm
    for (const LoadedNode& node : forces) {
      EXPECT_NEAR((node.acceleration - forces.front().acceleration).norm(), 0.0,
                  1e-12 * forces.front().acceleration.norm());
      const Vec2 at = lattice.grid.position(node.i, node.j);
      const double away = edge == Edge::left     ? at.x()
                          : edge == Edge::right  ? plate.width - at.x()
                          : edge == Edge::bottom ? at.y()
                                                 : plate.height - at.y();
      EXPECT_LT(away, depth) << name_of(edge);
    }
  }
}

// The layer is thinner there, but the total force is the same.
TEST(Tractions, InALayerOverAHoleKeepTheirResultant) {
  for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top}) {
    Plate plate = test::bare_plate(30, 30);  // a hole two rows behind every edge
    plate.cutouts.push_back({rectangle({1e-3, 1e-3}, {14e-3, 14e-3}), ""});
    plate.loads.tractions.push_back({edge, {7e6, 2e6}, 2e-3, {}});
    const Lattice lattice(plate, test::numerics());
    const Vec2 force = resultant(forces_of(plate, lattice), lattice);
    EXPECT_NEAR(force.x(), 7e6 * 15e-3, 1e-6) << name_of(edge);
    EXPECT_NEAR(force.y(), 2e6 * 15e-3, 1e-6) << name_of(edge);
  }
}

// Along any edge, at the edge and below it, where a function is evaluated at the node of the edge.
TEST(Tractions, TakeTheStressOfTheirPlaceAlongEveryEdge) {
  const auto field = [](const Vec2& at) { return Vec2(1e9 * at.x() + 3e9 * at.y(), 2e6); };
  for (const double depth : {0.0, 1.5e-3})
    for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top}) {
      Plate plate = test::bare_plate(30, 20);
      plate.loads.tractions.push_back({edge, VectorField(field), depth, {}});
      const Lattice lattice(plate, test::numerics());
      const double w = plate.width, h = plate.height, near = 0.25e-3;
      const bool along_x = edge == Edge::bottom || edge == Edge::top;
      const double length = along_x ? w : h;
      const double x = along_x ? 0.5 * w : edge == Edge::left ? near : w - near;
      const double y = !along_x ? 0.5 * h : edge == Edge::bottom ? near : h - near;
      const Vec2 force = resultant(forces_of(plate, lattice), lattice);
      EXPECT_NEAR(force.x(), (1e9 * x + 3e9 * y) * length, 1e-6) << name_of(edge);
      EXPECT_NEAR(force.y(), 2e6 * length, 1e-6) << name_of(edge);
    }
}

TEST(Loads, OfOneKindAddUpAndKeepTheirAmplitudes) {
  Plate plate = test::bare_plate(30, 20);
  plate.cutouts.push_back({rectangle({5e-3, 4e-3}, {9e-3, 6e-3}), "slot"});
  plate.loads.body_forces.push_back({rectangle({0, 0}, {5e-3, 10e-3}), {1e6, 0.0}, ramp(4e-6)});
  plate.loads.body_forces.push_back({rectangle({2.5e-3, 0}, {5e-3, 10e-3}), {0.0, 2e6}, {}});
  plate.loads.pressures.push_back({"slot", 1e6, pulse(1e-6, 2e-6)});
  plate.loads.pressures.push_back({"slot", 5e6, step_at(3e-6)});
  plate.loads.tractions.push_back({Edge::top, {0.0, 1e6}, 0.0, step_at(7e-6)});
  plate.loads.tractions.push_back({Edge::top, {0.0, 4e6}, 0.0, {}});
  const Lattice lattice(plate, test::numerics());
  const std::vector<SpreadForce> spread = spread_forces(plate, lattice);
  ASSERT_EQ(spread.size(), 6U);  // tractions, pressures, body forces
  const double at[] = {7e-6, 0.0, 2e-6, 3e-6, 3e-6, 0.0}, wanted[] = {1, 1, 1, 1, 0.75, 1};
  const double before[] = {6.9e-6, 0.0, 1.9e-6, 2.9e-6, 1e-6, 0.0}, was[] = {0, 1, 0, 0, 0.25, 1};
  for (std::size_t k = 0; k < spread.size(); ++k) {
    EXPECT_DOUBLE_EQ(spread[k].amplitude.at(at[k]), wanted[k]) << k;
    EXPECT_DOUBLE_EQ(spread[k].amplitude.at(before[k]), was[k]) << k;
  }
  EXPECT_NEAR(resultant(spread[0].nodes, lattice).y(), 1e6 * 15e-3, 1e-6);
  EXPECT_NEAR(resultant(spread[1].nodes, lattice).y(), 4e6 * 15e-3, 1e-6);
  EXPECT_NEAR(spread[3].nodes.front().acceleration.norm(),
              5.0 * spread[2].nodes.front().acceleration.norm(), 1e-3);
  const auto both = sum_of(spread[4].nodes, spread[5].nodes, lattice.grid);
  EXPECT_EQ(both.size(), spread[4].nodes.size());
  EXPECT_NEAR((resultant(both, lattice) - Vec2(1e6 * 5e-5, 2e6 * 2.5e-5)).norm(), 0.0, 1e-9);
}

TEST(Supports, HoldTheNodesOfTheirAreaAsTheySay) {
  Plate plate = test::bare_plate(30, 20);
  plate.cutouts.push_back({rectangle({0.0, 0.0}, {1e-3, 1e-3}), ""});  // 4 nodes
  Support pulled;
  pulled.region = rectangle({0, 0}, {2e-3, 10e-3});
  pulled.value = VectorField([](const Vec2& at) { return Vec2(3.0 * at.x(), 5.0 * at.y()); });
  pulled.along_y = false;
  pulled.amplitude = ramp(4e-6);
  Support moved;
  moved.kind = Support::Kind::velocity;
  moved.value = Vec2(1.0, -2.0);
  moved.along_x = false;
  plate.loads.supports = {pulled, moved};
  const Lattice lattice(plate, test::numerics());
  const std::vector<SpreadSupport> supports = spread_supports(plate, lattice);
  ASSERT_EQ(supports.size(), 2U);
  EXPECT_EQ(supports[0].kind, Support::Kind::displacement);
  EXPECT_EQ(supports[1].kind, Support::Kind::velocity);
  EXPECT_EQ(supports[0].amplitude.at(1e-6), 0.25);
  EXPECT_TRUE(supports[1].amplitude.is_constant());
  EXPECT_EQ(supports[0].nodes.size(), 4U * 20U - 4U);
  EXPECT_EQ(supports[1].nodes.size(), 30U * 20U - 4U);  // everywhere
  for (const HeldNode& node : supports[0].nodes) {
    const Vec2 at = lattice.grid.position(node.i, node.j);
    EXPECT_LT(at.x(), 2e-3);
    EXPECT_NEAR((node.value - Vec2(3.0 * at.x(), 5.0 * at.y())).norm(), 0.0, 1e-15);
    EXPECT_TRUE(node.along_x && !node.along_y);
  }
  for (const HeldNode& node : supports[1].nodes) {
    EXPECT_EQ(node.value, Vec2(1.0, -2.0));
    EXPECT_TRUE(!node.along_x && node.along_y);
  }
}

}  // namespace
}  // namespace hackle
