// SPDX-License-Identifier: MIT
#include "output/report/account.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/units.hpp"
#include "measure/bond_field.hpp"
#include "solver/observer.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

struct Told {
  std::vector<std::string> sentences;
  std::optional<double> first_break;  // s, as found beside the account
};

Told tell(Simulation& simulation, double duration) {
  CrackGrowth growth;
  growth.follow(simulation);
  Told told;
  const double end = simulation.time() + duration;
  while (simulation.time() < end - 1e-12) {
    simulation.step();
    growth.follow(simulation);
    if (!told.first_break && !simulation.broken_bonds().empty())
      told.first_break = simulation.time_of_step();
  }
  growth.count(simulation);
  told.sentences = account_of(simulation, summary_of(simulation), growth, crack_graph(growth));
  return told;
}

TEST(Account, SaysWhatCameClosestWhereNothingBroke) {
  Simulation simulation(test::edge_crack(2e6), test::numerics(1e-3, 4e-3), {1});
  const Told told = tell(simulation, 5e-6);
  EXPECT_EQ(told.first_break, std::nullopt);
  const auto shares = closest_to_breaking(simulation.view());
  EXPECT_THAT(told.sentences.front(),
              AllOf(HasSubstr("No bond broke"),
                    HasSubstr(fmt::format("{:.0f} % of its critical stretch",
                                          100.0 * *std::ranges::max_element(shares)))));
  EXPECT_THAT(told.sentences, Not(Contains(HasSubstr("forked"))));
}

TEST(Account, SaysThatNothingIsStretched) {
  Simulation simulation(test::bare_plate(20, 10), test::numerics(1e-3, 3e-3), {1});
  EXPECT_THAT(tell(simulation, 1e-6).sentences.front(), HasSubstr("nothing is stretched"));
}

TEST(Account, SaysWhenAndWhereTheFirstBondBroke) {
  Simulation simulation(test::edge_crack(14e6), test::numerics(1e-3, 4e-3), {1});
  const Told told = tell(simulation, 12e-6);
  ASSERT_TRUE(told.first_break);
  EXPECT_THAT(told.sentences.front(),
              HasSubstr(fmt::format("first bond broke at {}", quantity(*told.first_break, "s"))));
  EXPECT_THAT(told.sentences.front(), HasSubstr(", 20) mm"));  // on the line of the crack
  EXPECT_THAT(told.sentences, Contains(HasSubstr("1 tip runs on")));
  EXPECT_THAT(told.sentences, Contains(HasSubstr("c_R")));
  EXPECT_THAT(told.sentences, Contains(HasSubstr("the horizon is 4 mm")));
}

TEST(Account, TellsAForkAndHowFarToTrustIt) {
  Simulation simulation(test::edge_crack(24e6), test::numerics(0.5e-3, 2e-3), {1});
  const Told told = tell(simulation, 20e-6);
  EXPECT_THAT(told.sentences, Contains(HasSubstr("The crack forked at")));
  EXPECT_THAT(told.sentences, Contains(HasSubstr("degrees")));
  EXPECT_THAT(told.sentences, Contains(HasSubstr("2 tips run on")));
  EXPECT_THAT(told.sentences, Contains(HasSubstr("How far to trust it")));
}

// What came before anybody looked is not dated.
TEST(Account, DatesOnlyWhatWasSeen) {
  Simulation simulation(test::edge_crack(14e6), test::numerics(1e-3, 4e-3), {1});
  simulation.run(12e-6);
  const Told told = tell(simulation, 1e-6);
  EXPECT_THAT(told.sentences.front(), HasSubstr("The first bond broke before 12."));
}

}  // namespace
}  // namespace hackle
