// SPDX-License-Identifier: MIT
#include "lattice/load_map.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

std::vector<LoadedNode> forces_of(const Plate& plate, const Lattice& lattice) {
  std::vector<LoadedNode> sum;
  for (SpreadForce& force : spread_forces(plate, lattice)) {
    for (LoadedNode& node : force.nodes) node.acceleration *= force.course.at(0.0);
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
  // The projected width of the hole, to a cell on either side.
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
  plate.loads.heatings.push_back({rectangle({0.0, 0.0}, {5e-3, 2e-3}),
                                  ScalarField([](const Vec2& x) { return 1e6 * x.x(); }),
                                  ramp(1e-6)});
  const Lattice lattice(plate, test::numerics());
  const std::vector<SpreadHeat> heat = spread_heat(plate, lattice);
  ASSERT_EQ(heat.size(), 1U);
  EXPECT_EQ(heat.front().nodes.size(), 8U * 4U - 2U * 2U);
  for (const HeatedNode& node : heat.front().nodes) {
    EXPECT_LT(node.j, 4);
    EXPECT_LT(node.i, 8);
    const double alphaT = node.i < 2 ? 12e-6 : 4e-6;
    EXPECT_NEAR(node.strain, alphaT * 1e6 * lattice.grid.position(node.i, node.j).x(), 1e-15);
  }
  EXPECT_EQ(heat.front().course.at(0.5e-6), 0.5);
}

}  // namespace
}  // namespace hackle
