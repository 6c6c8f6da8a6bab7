// SPDX-License-Identifier: MIT
#include <vector>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "measure/energy.hpp"
#include "solver/simulation.hpp"
#include "solver/statics/breakage.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double duration = 10e-6;

// An edge crack, opened by leading top and bottom apart.
Plate opened(double shift, int columns = 40, int rows = 30) {
  Plate plate = test::bare_plate(columns, rows);
  plate.cracks.push_back({{0.0, 0.5 * plate.height}, {0.5 * plate.width, 0.5 * plate.height}});
  for (const auto& [edge, sign] : {std::pair{Edge::top, 1.0}, {Edge::bottom, -1.0}}) {
    Support support;
    support.region = strip(plate, edge, 2e-3);
    support.value = Vec2(0.0, sign * shift);
    support.amplitude = ramp(duration);
    plate.loads.supports.push_back(support);
    plate.no_fail.push_back(strip(plate, edge, 4e-3));
  }
  return plate;
}

class Timekeeper : public Observer {
 public:
  bool due(const Simulation&) override { return true; }
  void observe(const Simulation& simulation) override {
    times.push_back(simulation.time());
    if (static_cast<int>(times.size()) == interrupt_after) request_interrupt();
  }
  std::vector<double> times;
  int interrupt_after = -1;
};

TEST(Quasistatic, TimeGoesOnByIncrements) {
  Simulation simulation(opened(1e-6), test::numerics(), {1});
  Timekeeper clock;
  Observer* observers[] = {&clock};
  const QuasistaticResult result = simulation.load_slowly({duration, 4}, observers);
  EXPECT_THAT(result.passes, testing::ElementsAre(1, 1, 1, 1));
  EXPECT_EQ(result.broken, 0);
  EXPECT_TRUE(result.bears);
  ASSERT_EQ(clock.times.size(), 5U);
  for (int k = 0; k <= 4; ++k)
    EXPECT_DOUBLE_EQ(clock.times[static_cast<std::size_t>(k)], k * duration / 4);
  EXPECT_EQ(simulation.time(), duration);
  const Energy before = energy(simulation);
  simulation.run(200 * simulation.dt());  // the amplitude has ended: nothing moves
  EXPECT_LT(energy(simulation).kinetic, 1e-6 * before.strain);
}

TEST(Quasistatic, ACrackGrowsAlongTheMidlineUntilThePlateIsInTwo) {
  Simulation simulation(opened(8e-6, 30, 24), test::numerics(), {2});
  const QuasistaticResult result = simulation.load_slowly({duration, 4});
  EXPECT_TRUE(result.bears);  // the halves hang on their supports
  EXPECT_EQ(test::asymmetric_nodes(simulation, true), 0);
  // 15 columns are left, each with 40 bonds across at m = 4, fewer at the edge.
  EXPECT_GE(result.broken, 15 * 40 - 60);
  EXPECT_LE(result.broken, 15 * 40 + 100);
  EXPECT_EQ(result.broken, count_damage(simulation).broken_bonds);
  const Energy ledger = energy(simulation);
  EXPECT_LT(ledger.strain, 0.01 * ledger.broken);  // of crumbs that hang between the halves
  EXPECT_GT(ledger.released, 0.0);
  EXPECT_NEAR(ledger.residual(), 0.0, 5e-3 * ledger.external);  // forces are linear to the strain
}

TEST(Quasistatic, BitsDependNotOnThreads) {
  std::string hash;
  for (const int threads : {1, 3}) {
    Simulation simulation(opened(4e-6), test::numerics(), {threads});
    simulation.load_slowly({duration, 2});
    if (hash.empty()) hash = simulation.state().hash();
    EXPECT_EQ(simulation.state().hash(), hash);
  }
}

// With a dead load there is no rest once the crack has run through.
TEST(Quasistatic, SaysThatThePlateComesApart) {
  Plate plate = opened(0.0, 20, 24);
  plate.loads.supports.pop_back();
  plate.loads.tractions = {{Edge::bottom, {0.0, -80e6}}};
  plate.loads.tractions[0].amplitude = ramp(duration);
  Simulation simulation(plate, test::numerics(), {1});
  const QuasistaticResult result = simulation.load_slowly({duration, 2});
  EXPECT_FALSE(result.bears);
  EXPECT_THAT(result.why, testing::HasSubstr("quasistatic"));
  EXPECT_LE(result.passes.size(), 2U);
  EXPECT_GT(result.broken, 100);
  simulation.run(1e-6);  // it flies apart
  EXPECT_GT(energy(simulation).kinetic, 0.0);
}

TEST(Quasistatic, AnInterruptLeavesTheLastIncrement) {
  Simulation simulation(opened(1e-6), test::numerics(), {1});
  Timekeeper clock;
  clock.interrupt_after = 3;
  Observer* observers[] = {&clock};
  try {
    simulation.load_slowly({duration, 4}, observers);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
    EXPECT_THAT(error.what(), testing::StartsWith("quasistatic: interrupted"));
  }
  clear_interrupt();
  EXPECT_NEAR(simulation.time(), duration / 2, simulation.dt());
  EXPECT_THAT(simulation.load_slowly({duration / 2, 2}).passes, testing::ElementsAre(1, 1));
}

// Errors name the call that was made, and leave the plate as it was.
TEST(Quasistatic, ErrorsNameIt) {
  Plate pushed = test::bare_plate(20, 12);
  pushed.loads.tractions = {{Edge::right, {1e6, 0.0}}};
  Plate hit = test::bare_plate(20, 12);
  hit.loads.impactors = {{{5e-3, 20e-3}, 1e-3, {0, -1.0}, 1.0}};
  for (const Plate& plate : {pushed, hit}) {
    Simulation simulation(plate, test::numerics(), {1});
    const std::string before = simulation.state().hash();
    try {
      simulation.load_slowly({duration, 2});
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_THAT(error.what(), testing::StartsWith("quasistatic: "));
    }
    EXPECT_EQ(simulation.state().hash(), before);
    EXPECT_EQ(simulation.time(), 0.0);
  }
}

TEST(Quasistatic, RefusesWhatMakesNoSense) {
  Simulation simulation(opened(1e-6), test::numerics(), {1});
  EXPECT_THROW(simulation.load_slowly({0.0, 4}), Error);
  EXPECT_THROW(simulation.load_slowly({duration, 0}), Error);
  EXPECT_THROW(simulation.load_slowly({duration, 4, 0.0}), Error);
  EXPECT_THROW(simulation.load_slowly({1e300, 4}), Error);  // more steps than can be counted
}

TEST(Quasistatic, TheWorstBreakFirst) {
  const Lattice lattice(test::bare_plate(20, 10), test::numerics());
  BondBits bonds = lattice.bonds;
  const std::ptrdiff_t at = lattice.grid.layout().at(5, 5);
  const Breakage broken =
      break_worst({{at, 0, 1.05, 1.0}, {at, 1, 1.5, 2.0}, {at, 2, 1.4, 4.0}}, bonds);
  ASSERT_EQ(broken.broken_bonds.size(), 2U);
  EXPECT_EQ(broken.broken_bonds[1].bit, 4U);
  EXPECT_EQ(broken.excess, 6.0);
  EXPECT_TRUE(bonds.holds(at, 0));
  EXPECT_FALSE(bonds.holds(at, 1) || bonds.holds(at, 2));
  EXPECT_TRUE(break_worst({}, bonds).broken_bonds.empty());
}

// A run goes to the first step at or after its end; what it went too far is not added up.
TEST(Quasistatic, KeepsTheTimeThatWasAskedFor) {
  Simulation simulation(test::bare_plate(20, 10), test::numerics(), {1});
  simulation.run(1.03e-6);
  simulation.load_slowly({0.5e-6, 2, 1e-6, {}});
  EXPECT_NEAR(simulation.time(), 1.53e-6, 1e-15);
  Simulation pieces(test::bare_plate(20, 10), test::numerics(), {1});
  for (int k = 0; k < 40; ++k) {
    pieces.run(1e-9);
    pieces.load_slowly({1e-9, 1, 1e-6, {}});
  }
  EXPECT_NEAR(pieces.end_time(), 80e-9, 1e-15);
  EXPECT_LT(pieces.time(), 80e-9 + pieces.dt());
}

}  // namespace
}  // namespace hackle
