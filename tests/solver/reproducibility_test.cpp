// SPDX-License-Identifier: MIT
// The same bits for any number of threads, any instruction set, and any division of a run into
// parts.
#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

std::string hash_after(double duration, Execution execution, const Plate& plate,
                       const Numerics& numerics = test::numerics()) {
  Simulation simulation(plate, numerics, execution);
  simulation.run(duration);
  return simulation.state().hash();
}

Numerics in(Precision precision) {
  Numerics numerics = test::numerics();
  numerics.precision = precision;
  return numerics;
}

class Deck : public testing::TestWithParam<Precision> {};

TEST_P(Deck, DoesNotDependOnThreads) {
  const Plate plate = test::edge_crack(24e6);
  const std::string alone = hash_after(12e-6, {1}, plate, in(GetParam()));
  for (int threads = 2; threads <= 8; ++threads)
    EXPECT_EQ(hash_after(12e-6, {threads}, plate, in(GetParam())), alone) << threads;
}

TEST_P(Deck, DoesNotDependOnTheInstructionSet) {
  const Plate plate = test::edge_crack(24e6);
  const std::string baseline =
      hash_after(12e-6, {1, InstructionSet::baseline}, plate, in(GetParam()));
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_supported(set)) continue;
    EXPECT_EQ(hash_after(12e-6, {1, set}, plate, in(GetParam())), baseline);
  }
}

TEST_P(Deck, DoesNotDependOnHowARunIsCut) {
  const Plate plate = test::edge_crack(24e6);
  Simulation simulation(plate, in(GetParam()), {1});
  for (const double part : {1e-6, 3.3e-6, 0.0, 7.7e-6}) simulation.run(part);
  EXPECT_EQ(simulation.state().hash(), hash_after(12e-6, {1}, plate, in(GetParam())));
}

TEST_P(Deck, AKeptStateGoesOnToTheSameBits) {
  Simulation simulation(test::edge_crack(24e6), in(GetParam()), {1});
  simulation.run(8e-6);
  const State kept = simulation.state();
  simulation.run(4e-6);
  const std::string straight = simulation.state().hash();
  simulation.restore(kept);
  EXPECT_EQ(simulation.state().hash(), kept.hash());
  while (simulation.time() < 12e-6) simulation.step();
  EXPECT_EQ(simulation.state().hash(), straight);
}

TEST_P(Deck, ACopyIsAnotherFuture) {
  Simulation one(test::edge_crack(24e6), in(GetParam()), {1});
  one.run(6e-6);
  Simulation other = one;
  one.run(3e-6);
  other.run(3e-6);
  EXPECT_EQ(one.state().hash(), other.state().hash());
}

TEST_P(Deck, QuestionsDoNotChangeABit) {
  Simulation asked(test::edge_crack(24e6), in(GetParam()), {1});
  while (asked.time() < 12e-6) {
    asked.step();
    EXPECT_GT(test::largest(asked.velocities()), 0.0);
  }
  EXPECT_EQ(asked.state().hash(), hash_after(12e-6, {1}, test::edge_crack(24e6), in(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Precisions, Deck, testing::Values(Precision::f64, Precision::f32),
                         [](const auto& precision) {
                           return std::string(name_of(precision.param));
                         });

// One row of a table in which every pair of choices occurs, for every m.
struct Choice {
  double m;
  Precision precision;
  double alpha;
  bool no_fail;
  Quadrature quadrature;
  int threads;
};

void PrintTo(const Choice& choice, std::ostream* out) {
  *out << "m = " << choice.m << ", " << choice.threads << " threads";
}

std::vector<Choice> choices() {
  std::vector<Choice> list;
  for (const double m : {2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 16.0})
    for (int k = 0; k < 8; ++k) {
      const bool a = (k & 1) != 0, b = (k & 2) != 0, c = (k & 4) != 0;
      list.push_back({m, a ? Precision::f32 : Precision::f64, b ? 0.25 : 0.0, c,
                      a != (b != c) ? Quadrature::ramp : Quadrature::full,
                      2 + static_cast<int>(list.size()) % 7});
    }
  return list;
}

class EveryChoice : public testing::TestWithParam<Choice> {
 protected:
  // Makes a plate whose vibration increases from left to right, where a considerable share of its
  // bonds break.
  Simulation plate(Execution execution) const {
    const Choice& choice = GetParam();
    Plate plate = test::bare_plate(39, 50);
    plate.material.alpha = choice.alpha;
    plate.cracks.push_back({{3e-3, 4e-3}, {11e-3, 19e-3}, Born::broken});
    plate.loads.tractions.push_back({Edge::left, {2e6, 1e6}});
    if (choice.no_fail) plate.no_fail.push_back(strip(plate, Edge::top, 4e-3));
    Numerics numerics = test::numerics(0.5e-3, choice.m * 0.5e-3);
    numerics.precision = choice.precision;
    numerics.quadrature = choice.quadrature;
    Simulation simulation(plate, numerics, execution);
    const double s0 = simulation.lattice().calibration.s0;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-2.0 * s0, 2.0 * s0);
    simulation.restore(test::thrown(simulation, [&](const Vec2& x) {
      return Vec2(std::max(0.0, 0.5 + x.x() / 39.0) * Vec2(uniform(random), uniform(random)));
    }));
    return simulation;
  }
  int steps() const { return GetParam().m > 8.0 ? 40 : 100; }

  std::string hash(Execution execution) const {
    Simulation simulation = plate(execution);
    simulation.run(steps() * simulation.dt());
    return simulation.state().hash();
  }
};

TEST_P(EveryChoice, GivesTheSameBitsHoweverItIsCarriedOut) {
  Simulation whole = plate({1});
  whole.run(steps() * whole.dt());
  const std::int64_t left = whole.state().bonds.count(), all = whole.lattice().bonds.count();
  EXPECT_GT(all - left, 1000);
  EXPECT_GT(left, all / 20);

  EXPECT_EQ(hash({GetParam().threads}), whole.state().hash());
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2}) {
    if (!is_supported(set)) continue;
    EXPECT_EQ(hash({1, set}), whole.state().hash());
  }

  Simulation first = plate({1});
  first.run(steps() / 10 * first.dt());
  Simulation second = plate({1});
  second.restore(first.state());
  second.run((steps() - steps() / 10) * second.dt());
  EXPECT_EQ(second.state().step, whole.state().step);
  EXPECT_EQ(second.state().hash(), whole.state().hash());
}

INSTANTIATE_TEST_SUITE_P(Choices, EveryChoice, testing::ValuesIn(choices()),
                         [](const auto& choice) {
                           const Choice& c = choice.param;
                           return fmt::format("m{:g}_{}{}{}_{}", c.m, name_of(c.precision),
                                              c.alpha > 0.0 ? "_history" : "",
                                              c.no_fail ? "_guarded" : "", name_of(c.quadrature));
                         });

}  // namespace
}  // namespace hackle
