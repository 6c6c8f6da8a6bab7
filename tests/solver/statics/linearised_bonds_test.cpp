// SPDX-License-Identifier: MIT
#include "solver/statics/linearised_bonds.hpp"

#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

NodeVectors displacements(const State& state) {
  NodeVectors u(state.layout);
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i) {
      const auto at = static_cast<std::size_t>(state.layout.at(i, j));
      u.x[at] = state.u(i, j).x();
      u.y[at] = state.u(i, j).y();
    }
  return u;
}

// A lattice whose bonds break at twice their length, one in five of them gone, nodes thrown about,
// with `growth` on top.
struct Scene {
  explicit Scene(double growth, double m = 3.0) : simulation(plate(), numerics(m), {1}) {
    State state = simulation.state();
    const NodeLayout layout = state.layout;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shake(-1e-2, 1e-2);
    for (int j = 0; j < layout.ny; ++j)
      for (int i = 0; i < layout.nx; ++i) {
        state.set_u(i, j, {growth * i + shake(random), growth * j + shake(random)});
        simulation.lattice().family.for_each_bond([&](int, int, const Vec2&, double, int bit) {
          if (random() % 5 == 0) state.bonds.clear(layout.at(i, j), bit);
        });
      }
    simulation.restore(state);
  }
  static Plate plate() {
    Plate plate = test::bare_plate(19, 14);
    plate.material.G0 *= 1e8;
    return plate;
  }
  static Numerics numerics(double m) { return test::numerics(0.5e-3, m * 0.5e-3); }

  Simulation simulation;
};

TEST(LinearisedBonds, ItsForcesAreThoseOfTheEngine) {
  for (const double m : {3.0, 4.0, 5.5}) {
    const Scene scene(0.0, m);
    const Simulation& simulation = scene.simulation;
    const State& state = simulation.state();
    const LinearisedBonds net(simulation.lattice(), state, Threads(2));
    NodeVectors force(state.layout);
    net.forces(displacements(state), force);
    const std::vector<Vec2> expected = test::accelerations(simulation);
    const double unit = net.unit_of_force() / simulation.lattice().rho * simulation.dt() *
                        simulation.dt() / simulation.lattice().grid.dx;
    const double max = test::largest(expected);
    for (int j = 0; j < state.layout.ny; ++j)
      for (int i = 0; i < state.layout.nx; ++i) {
        const auto at = static_cast<std::size_t>(state.layout.at(i, j));
        const Vec2 found(unit * force.x[at], unit * force.y[at]);
        ASSERT_LT((found - expected[simulation.lattice().grid.index(i, j)]).norm(), 1e-13 * max);
      }
  }
}

// Central differences err by the square of the change, the tangent by the rounding of f32.
class TangentOfBonds : public testing::TestWithParam<std::pair<double, Tangent>> {};
TEST_P(TangentOfBonds, IsTheDerivativeOfTheirForces) {
  const auto [growth, tangent] = GetParam();
  const Scene scene(growth);
  const State& state = scene.simulation.state();
  LinearisedBonds net(scene.simulation.lattice(), state, Threads(2));
  const NodeVectors u = displacements(state);
  net.linearise(u, tangent);
  NodeVectors p(state.layout), ahead = u, behind = u, up(state.layout), down(state.layout),
                               change(state.layout);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  constexpr double little = 1e-5;
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i) {
      const auto at = static_cast<std::size_t>(state.layout.at(i, j));
      p.x[at] = any(random);
      p.y[at] = any(random);
      ahead.x[at] += little * p.x[at];
      ahead.y[at] += little * p.y[at];
      behind.x[at] -= little * p.x[at];
      behind.y[at] -= little * p.y[at];
    }
  net.forces(ahead, up);
  net.forces(behind, down);
  for (int j = 0; j < state.layout.ny; ++j) {
    net.apply_row(p, change, j);
    for (int i = 0; i < state.layout.nx; ++i) {
      const auto at = static_cast<std::size_t>(state.layout.at(i, j));
      ASSERT_NEAR(change.x[at], (up.x[at] - down.x[at]) / (2.0 * little), 1e-5);
      ASSERT_NEAR(change.y[at], (up.y[at] - down.y[at]) / (2.0 * little), 1e-5);
    }
  }
}

// Nothing is left out of the positive one where no bond is compressed.
INSTANTIATE_TEST_SUITE_P(Bonds, TangentOfBonds,
                         testing::Values(std::pair{0.0, Tangent::exact},
                                         std::pair{-0.1, Tangent::exact},
                                         std::pair{0.2, Tangent::exact},
                                         std::pair{0.2, Tangent::positive}));

TEST(LinearisedBonds, ItsOwnStiffnessIsTheForceThatAnswersOneNode) {
  const Scene scene(0.0);
  const State& state = scene.simulation.state();
  LinearisedBonds net(scene.simulation.lattice(), state, Threads(1));
  net.linearise(displacements(state), Tangent::exact);
  NodeVectors p(state.layout), change(state.layout);
  const auto at = static_cast<std::size_t>(state.layout.at(4, 6));
  p.x[at] = 1.0;
  net.apply_row(p, change, 6);
  EXPECT_NEAR(-change.x[at], net.own_stiffness(4, 6).xx, 1e-12);
  EXPECT_NEAR(-change.y[at], net.own_stiffness(4, 6).xy, 1e-12);
}

}  // namespace
}  // namespace hackle
