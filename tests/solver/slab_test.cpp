// SPDX-License-Identifier: MIT
// A plate that several ranks solve has the bits of one that a single process solves. Here ranks are
// threads; tests/app/ranks_test.cpp starts processes.
#include "solver/slab.hpp"

#include <cstdlib>
#include <functional>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"
#include "support/thread_ranks.hpp"

namespace hackle {
namespace {

using test::bare_plate;
using test::ThreadRanks;
using testing::ElementsAre;
using testing::HasSubstr;

// Hashes and counts of a run, which must not depend on the ranks.
struct Result {
  std::string hash;
  double external = 0.0;
  std::int64_t step = 0;
  std::size_t broken = 0;
  bool operator==(const Result&) const = default;
};

void PrintTo(const Result& result, std::ostream* out) {
  *out << result.hash << " " << result.external << " " << result.step << " " << result.broken;
}

using Work = std::function<void(Simulation&)>;

Result result_of(const Plate& plate, const Numerics& numerics, const Work& work,
                 Execution execution) {
  Simulation simulation(plate, numerics, execution);
  work(simulation);
  const Ledger ledger = simulation.ledger();
  return {simulation.state().hash(), ledger.external, simulation.state().step,
          simulation.broken_bonds().size()};
}

void expect_same_on_ranks(const Plate& plate, const Numerics& numerics, const Work& work,
                          std::initializer_list<int> counts = {2, 3, 4, 6}) {
  const Result alone = result_of(plate, numerics, work, {1});
  for (const int count : counts)
    for (const int threads : {1, 2}) {
      std::vector<Result> results(static_cast<std::size_t>(count));
      ThreadRanks(count).run([&](Ranks& ranks) {
        results[static_cast<std::size_t>(ranks.rank())] =
            result_of(plate, numerics, work, {.threads = threads, .ranks = &ranks});
      });
      for (const Result& result : results)
        EXPECT_EQ(result, alone) << count << " ranks of " << threads << " threads";
    }
}

void run_on(Simulation& simulation) {
  simulation.run(12e-6);
}

Numerics of(Precision precision, double fidelity = 0.0) {
  Numerics numerics = test::numerics();
  numerics.precision = precision;
  numerics.fidelity = fidelity;
  return numerics;
}

class Slabs : public testing::TestWithParam<Precision> {};

TEST_P(Slabs, OfAPlateThatBreaks) {
  expect_same_on_ranks(test::edge_crack(24e6), of(GetParam()), run_on);
}

TEST_P(Slabs, WithAHistory) {
  Plate plate = test::edge_crack(24e6);
  plate.material.alpha = 0.25;
  expect_same_on_ranks(plate, of(GetParam()), run_on, {3});
}

TEST_P(Slabs, OfSeveralMaterialsAndStrengths) {
  Plate plate = test::edge_crack(20e6);
  Material soft = test::duran50();
  soft.E = 20e9;
  soft.rho = 1200.0;
  plate.inclusions.push_back({Ellipse{{0.07, 0.02}, {0.006, 0.006}}, soft});
  plate.scatter = Scatter{.spread = 8.0, .correlation = 1e-3};
  expect_same_on_ranks(plate, of(GetParam()), run_on, {3});
}

TEST_P(Slabs, WithLinearTiles) {
  expect_same_on_ranks(test::edge_crack(18e6), of(GetParam(), 0.5), run_on, {3, 6});
}

TEST_P(Slabs, WithSupportsDampingAndAbsorbingEdges) {
  Plate plate = test::edge_crack(12e6);
  plate.loads.damping = 3e4;
  plate.loads.absorbers.push_back({Absorber::Where::right});
  Support grip;
  grip.region = strip(plate, Edge::left, 2e-3);
  grip.kind = Support::Kind::velocity;
  grip.value = VectorField(Vec2(-0.5, 0.0));
  plate.loads.supports.push_back(grip);
  expect_same_on_ranks(plate, of(GetParam()), run_on, {3});
}

TEST_P(Slabs, WithContactAndImpact) {
  Plate plate = test::edge_crack(10e6);
  plate.contact = Contact{};
  Impactor disc;
  disc.centre = {0.1041, 0.02};
  disc.radius = 4e-3;
  disc.velocity = {-60.0, 0.0};
  disc.mass = 0.1;
  plate.loads.impactors.push_back(disc);
  expect_same_on_ranks(plate, of(GetParam()), run_on, {3});
}

TEST_P(Slabs, WhileThePlateDriftsAwayAndLoadsChange) {
  Plate plate = bare_plate(80, 100);
  InitialCondition start;
  start.velocity = VectorField(Vec2(20.0, 5.0));
  plate.initial_conditions.push_back(start);
  expect_same_on_ranks(plate, of(GetParam()),
                       [](Simulation& simulation) {
                         simulation.run(8e-6);
                         Loads loads = simulation.plate().loads;
                         loads.tractions.push_back({Edge::top, {0.0, 30e6}});
                         simulation.set_loads(loads);
                         simulation.run(6e-6);
                       },
                       {4});
}

TEST_P(Slabs, AtRestAndOnFromThere) {
  Plate plate = bare_plate(40, 60);
  plate.loads.tractions.push_back({Edge::top, {0.0, 4e6}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -4e6}});
  expect_same_on_ranks(plate, of(GetParam()),
                       [](Simulation& simulation) {
                         simulation.relax();
                         simulation.run(5e-6);
                       },
                       {3});
}

// After 256 steps waves from the top have not reached the lowest slab, which costs nothing: then
// rows change hands.
TEST_P(Slabs, WhoseRowsChangeHands) {
  Plate plate = bare_plate(40, 900);
  plate.loads.tractions.push_back({Edge::top, {0.0, 6e6}});
  const auto hash_after_300_steps = [&](Ranks* ranks) {
    MovingPlate moving(plate, of(GetParam()), {.threads = 1, .ranks = ranks}, {});
    const std::vector<int> at_first = moving.slab().begins;
    while (moving.state().step < 300) moving.step();
    EXPECT_EQ(moving.slab().begins == at_first, ranks == nullptr);
    moving.complete();
    return moving.state().hash();
  };
  const std::string alone = hash_after_300_steps(nullptr);
  ThreadRanks(3).run([&](Ranks& ranks) { EXPECT_EQ(hash_after_300_steps(&ranks), alone); });
}

INSTANTIATE_TEST_SUITE_P(Precisions, Slabs, testing::Values(Precision::f64, Precision::f32),
                         [](const auto& precision) {
                           return std::string(name_of(precision.param));
                         });

TEST(Slabs, OfRandomScenesHaveTheSameBits) {
  std::mt19937 random(23);
  const auto pick = [&](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most));
  };
  const char* asked = std::getenv("HACKLE_RANK_SCENES");
  const int scenes = asked == nullptr ? 100 : std::atoi(asked);
  for (int scene = 0; scene < scenes; ++scene) {
    Plate plate = bare_plate(20 + pick(60), 48 + pick(60));
    const auto place = [&] {
      return Vec2(0.01 * pick(101) * plate.width, 0.01 * pick(101) * plate.height);
    };
    for (int k = pick(4); k > 0; --k) {
      const Vec2 from = place(), to = place();
      if (from != to) plate.cracks.push_back({from, to, Born::broken});
    }
    plate.material.alpha = pick(3) == 0 ? 0.25 : 0.0;
    plate.loads.tractions.push_back({Edge::top, {1e6 * pick(40), 1e6 * pick(60)}});
    plate.loads.damping = pick(3) == 0 ? 1e4 : 0.0;
    Numerics numerics = of(pick(2) == 0 ? Precision::f32 : Precision::f64,
                           pick(3) == 0 && plate.material.alpha == 0.0 ? 0.4 : 0.0);
    numerics.horizon = (2 + pick(5)) * 0.5e-3;
    SCOPED_TRACE(fmt::format("scene {}", scene));
    expect_same_on_ranks(plate, numerics, [](Simulation& s) { s.run(8e-6); }, {2 + pick(3)});
  }
}

TEST(Slabs, MoreRanksThanRowsOfTilesAreRefusedWithTheMostThatServe) {
  ThreadRanks(4).run([](Ranks& ranks) {
    try {
      const Simulation simulation(bare_plate(40, 20), test::numerics(),
                                  {.threads = 1, .ranks = &ranks});
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_THAT(error.what(), HasSubstr("4 ranks"));
      EXPECT_THAT(error.what(), HasSubstr("at most 2 ranks"));
    }
  });
}

TEST(Slabs, AskForRowsWithinReachAndNoOthers) {
  const std::vector<int> begins{0, 8, 16, 40};
  const auto texts = [](const std::vector<RowsOfRank>& list) {
    std::vector<std::string> all;
    for (const RowsOfRank& rows : list)
      all.push_back(fmt::format("{}: {}-{}", rows.rank, rows.begin, rows.end));
    return all;
  };
  EXPECT_THAT(texts(rows_to_receive(begins, 1, 4, 4)), ElementsAre("0: 4-8", "2: 16-20"));
  EXPECT_THAT(texts(rows_to_receive(begins, 2, 12, 12)), ElementsAre("0: 4-8", "1: 8-16"));
  EXPECT_THAT(texts(rows_to_send(begins, 0, 12, 12)), ElementsAre("1: 0-8", "2: 4-8"));
}

TEST(Slabs, AreCutByWhatTheyCost) {
  const std::vector<int> rows{0, 8, 16, 24, 32, 40, 48, 56, 64};
  ThreadRanks(2).run([&](Ranks& ranks) {
    const Slab slab{&ranks, {0, 32, 64}};
    const auto cut = [&](double first, double second) {
      return slabs_of_equal_cost(slab, rows, std::vector<double>{first, second});
    };
    EXPECT_THAT(cut(1.0, 1.0), ElementsAre(0, 32, 64));
    EXPECT_THAT(cut(1.0, 3.0), ElementsAre(0, 40, 64));  // 1 + 0.75 of 4; a row later 2.5
    EXPECT_THAT(cut(1.0, 0.0), ElementsAre(0, 16, 64));
    EXPECT_THAT(cut(0.0, 1.0), ElementsAre(0, 48, 64));
  });
}

TEST(Slabs, SumsOfRowsDoNotDependOnWhoHasThem) {
  std::mt19937 random(7);
  std::vector<double> values(40 * 30);
  for (double& value : values)
    value = std::ldexp(static_cast<double>(random()) - 2e9, static_cast<int>(random() % 60));
  const auto sum = [&](const Slab& slab) {
    RowSum rows(slab, 1.0);
    for (int j = slab.begin(); j < slab.end(40); ++j)
      for (int i = 0; i < 30; ++i) rows.add(j, values[static_cast<std::size_t>(30 * j + i)]);
    return rows.value();
  };
  const double alone = sum(undivided);
  ThreadRanks(3).run([&](Ranks& ranks) { EXPECT_EQ(sum({&ranks, {0, 8, 16, 40}}), alone); });
}

}  // namespace
}  // namespace hackle
