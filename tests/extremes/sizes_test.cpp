// SPDX-License-Identifier: MIT
// The smallest plates and a large one.
#include <gtest/gtest.h>

#include "base/machine.hpp"
#include "lattice/needs.hpp"
#include "measure/energy.hpp"
#include "support/outcome.hpp"
#include "support/reference.hpp"
#include "support/scenes.hpp"
#include "support/skipping.hpp"

namespace hackle {
namespace {

TEST(OneNode, FallsFreely) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Plate plate = test::bare_plate(1, 1);
    plate.loads.tractions.push_back({Edge::top, {3e5, 1e5}});
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(plate, numerics, {1});
    const Vec2 a = simulation.actions().forces.front().acceleration;
    simulation.run(1000.0 * simulation.dt());
    // Leapfrog is exact for a constant force, up to a thousand rounding errors of v and u.
    const Vec2 way = 0.5 * a * std::pow(simulation.time(), 2);
    EXPECT_LT((simulation.displacement(0, 0) - way).norm() / way.norm(),
              precision == Precision::f64 ? 1e-13 : 1e-4);
    test::expect_numbers(simulation, "one node");
  }
}

struct Chain {
  int nx, ny;
};

// The chain is pulled at its end until it breaks.
TEST(AChain, BreaksAsTheReferenceSays) {
  for (const Chain& chain : {Chain{1, 2}, Chain{2, 1}, Chain{1, 37}, Chain{300, 1}, Chain{2, 40}})
    for (const double m : {2.0, 4.0, 16.0}) {
      Plate plate = test::bare_plate(chain.nx, chain.ny);
      plate.loads.tractions.push_back(
          {chain.nx > chain.ny ? Edge::right : Edge::top, {20e6, 30e6}});
      Simulation simulation(plate, test::numerics(0.5e-3, m * 0.5e-3), {1});
      test::Reference reference(simulation);
      for (int n = 0; n < 200; ++n) {
        simulation.step();
        reference.step();
      }
      EXPECT_EQ(reference.differing_bonds(simulation), 0) << chain.nx << " x " << chain.ny;
      test::expect_numbers(simulation, "chain");
    }
}

// Away from its ends, and before waves from there arrive, a wide plate behaves like a narrow one.
TEST(ALargePlate, IsLikeASmallOne) {
  constexpr int size = 4000, narrow = 64, steps = 6, m = 4;
  HACKLE_NEEDS(available_memory() >= std::uint64_t{4} << 30, "less than 4 GB are free");
  const auto solve = [](int nx, int ny) {
    Plate plate = test::bare_plate(nx, ny);
    plate.loads.tractions.push_back({Edge::top, {0.0, 40e6}});
    Numerics numerics = test::numerics();
    numerics.precision = Precision::f32;
    Simulation simulation(plate, numerics);
    for (int n = 0; n < steps; ++n) simulation.step();
    return simulation;
  };
  const Simulation large = solve(size, size), small = solve(narrow, narrow);
  EXPECT_EQ(large.lattice().grid.nodes(), 16'000'000U);
  for (int i = m * steps; i < size - m * steps; i += 7)
    for (int row = 1; row <= m * steps + 1; ++row)
      ASSERT_EQ(large.state().u(i, size - row), small.state().u(narrow / 2, narrow - row));
  EXPECT_EQ(large.state().u(size / 2, 0), Vec2(0, 0));
  EXPECT_EQ(static_cast<double>(large.bytes()), memory_of(large.plate(), large.numerics()).kept);
}

TEST(ATooLargePlate, IsRefusedBeforeAnythingIsAllocated) {
  for (const double size : {1e3, 1e6, 1e12}) {
    Plate plate = test::bare_plate(1, 1);
    plate.width = plate.height = size;
    EXPECT_EQ(test::outcome(plate, test::numerics(), 1, "too large"), test::Outcome::refused);
  }
}

}  // namespace
}  // namespace hackle
