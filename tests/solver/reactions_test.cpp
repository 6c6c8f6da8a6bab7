// SPDX-License-Identifier: MIT
// Forces on what bears a plate, against balances of momentum and closed forms.
#include <cmath>

#include <gmock/gmock.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double dx_of_reactions = 0.5e-3;

Support held(const Plate& plate, Edge edge, std::string name) {
  Support support;
  support.region = Region(strip(plate, edge, 2e-3));
  support.kind = Support::Kind::velocity;
  support.name = std::move(name);
  return support;
}

// Returns the momentum of all nodes, half a step behind, kg/s per m of thickness.
Vec2 momentum(const Simulation& simulation) {
  const Grid& grid = simulation.lattice().grid;
  Vec2 sum(0, 0);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      sum += simulation.lattice().rho * grid.dx * grid.dx * (grid.dx / simulation.dt()) *
             simulation.state().v(i, j);
  return sum;
}

Vec2 loads_on(const Simulation& simulation) {
  const double node = simulation.lattice().rho * dx_of_reactions * dx_of_reactions;
  Vec2 sum(0, 0);
  for (const LoadedNode& load : simulation.actions().forces)
    sum += load.inertia * node * load.acceleration;
  return sum;
}

const Reaction& reaction_named(const std::vector<Reaction>& list, const std::string& name) {
  for (const Reaction& one : list)
    if (one.name == name) return one;
  ADD_FAILURE() << name;
  return list.front();
}

// In every step the momentum grows by what the loads do less what the supports take, which the
// leapfrog keeps to rounding.
TEST(Reactions, OfSupportsBalanceTheMomentumOfEveryStep) {
  Plate plate = test::bare_plate(40, 20);
  plate.material.G0 = 1e6;  // nothing breaks: a bond that the next step breaks still pulls here
  plate.loads.tractions.push_back({Edge::top, {2e6, 5e6}});
  plate.loads.supports.push_back(held(plate, Edge::left, "grip"));
  Support pulled = held(plate, Edge::right, "");
  pulled.value = Vec2(5.0, 0.0);
  pulled.along_y = false;
  pulled.amplitude = ramp(2e-6);
  plate.loads.supports.push_back(pulled);
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(1e-6);
  double largest = 0.0;
  for (int step = 0; step < 20; ++step) {
    const Vec2 before = momentum(simulation), loads = loads_on(simulation);
    const std::vector<Reaction> list = simulation.reactions();
    const Vec2 borne = reaction_named(list, "grip").force + reaction_named(list, "support2").force;
    EXPECT_EQ(reaction_named(list, "support2").force.y(), 0.0);
    simulation.step();
    const Vec2 gained = (momentum(simulation) - before) / simulation.dt();
    EXPECT_LT((loads - borne - gained).norm(), 1e-9 * (loads.norm() + borne.norm()));
    largest = std::max(largest, borne.norm());
  }
  EXPECT_GT(largest, 1e4);
}

TEST(Reactions, OfAnImpactorIsItsChangeOfMomentum) {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.impactors.push_back({{10e-3, 14.01e-3}, 4e-3, {0.0, -20.0}, 2.0, 0.0, 1.0, "ball"});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(1e-6);
  const auto velocity = [&] {
    return Vec2(dx_of_reactions / simulation.dt() * simulation.state().discs[0].velocity);
  };
  for (int step = 0; step < 20; ++step) {
    const Vec2 before = velocity();
    const Reaction ball = reaction_named(simulation.reactions(), "ball");
    EXPECT_GT(ball.force.y(), 0.0);
    // A push along the line through its centre.
    EXPECT_NEAR(ball.moment, ball.centre.x() * ball.force.y() - ball.centre.y() * ball.force.x(),
                0.05 * ball.centre.x() * ball.force.y());
    simulation.step();
    EXPECT_LT((2.0 * (velocity() - before) - simulation.dt() * ball.force).norm(),
              1e-9 * simulation.dt() * ball.force.norm());
  }
}

TEST(Reactions, OfAFoundationAreItsForcesOnTheNodesTurnedRound) {
  Plate plate = test::bare_plate(20, 20);
  Foundation bed;
  bed.stiffness = 1e13;
  bed.name = "bed";
  plate.loads.foundations.push_back(bed);
  plate.initial_conditions.push_back({{}, {}, Vec2(3.0, -1.0)});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(2e-6);
  const Reaction found = reaction_named(simulation.reactions(), "bed");
  EXPECT_GT(found.force.norm(), 1e3);
  EXPECT_LT((found.force + loads_on(simulation)).norm(), 1e-12 * found.force.norm());
  // All nodes move alike: the resultant goes through the middle.
  EXPECT_NEAR(found.moment, found.centre.x() * found.force.y() - found.centre.y() * found.force.x(),
              1e-9 * found.force.norm());
}

// A bar of 30 x 5 mm, pulled slowly: the force is E times the height and the strain of its middle,
// where it is uniform; the correction of surfaces leaves 1 % of E (src/lattice/README.md 3.9).
TEST(Reactions, OfABarInSlowTensionAreThoseOfHooke) {
  Plate plate = test::bare_plate(60, 10);
  Support left = held(plate, Edge::left, "left"), right = held(plate, Edge::right, "right");
  left.along_y = right.along_y = false;
  right.kind = Support::Kind::displacement;
  right.value = Vec2(3e-6, 0.0);
  right.amplitude = ramp(1e-6);
  plate.loads.supports = {left, right};
  Numerics numerics = test::numerics();
  numerics.surface = Surface::energy;
  Simulation simulation(plate, numerics, {1});
  simulation.load_slowly({1e-6, 1, 1e-9, {}});
  const double strain = (simulation.displacement(39, 5).x() - simulation.displacement(20, 5).x()) /
                        (19 * dx_of_reactions);
  const double hooke = 65e9 * 5e-3 * strain;
  const std::vector<Reaction> list = simulation.reactions();
  const Reaction &one = reaction_named(list, "left"), &other = reaction_named(list, "right");
  EXPECT_NEAR(one.force.x(), hooke, 0.02 * hooke);
  EXPECT_NEAR(other.force.x(), -one.force.x(), 1e-6 * hooke);
  EXPECT_NEAR(other.moved.x(), 3e-6, 1e-15);
  EXPECT_NEAR(other.centre.x(), 29e-3 + 3e-6, 1e-9);
}

// A clamp bears the load at the other end, and its moment about the corner: of forces on the last
// column of nodes, half a spacing within the edge.
TEST(Reactions, OfACantileverHaveItsMoment) {
  Plate plate = test::bare_plate(60, 12);
  plate.loads.tractions.push_back({Edge::right, {0.0, 1e6}});
  plate.loads.supports.push_back(held(plate, Edge::left, "wall"));
  Simulation simulation(plate, test::numerics(), {1});
  simulation.relax({1e-10, {}});
  const double force = 1e6 * 6e-3, arm = 30e-3 - 0.5 * dx_of_reactions;
  const Reaction wall = reaction_named(simulation.reactions(), "wall");
  EXPECT_NEAR(wall.force.y(), force, 1e-6 * force);
  EXPECT_NEAR(wall.force.x(), 0.0, 1e-6 * force);
  EXPECT_NEAR(wall.moment, force * arm, 1e-4 * force * arm);  // less what it bends
}

}  // namespace
}  // namespace hackle
