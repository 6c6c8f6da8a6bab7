// SPDX-License-Identifier: MIT
#include "store/journal.hpp"

#include <gmock/gmock.h>

#include "store/inputs.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

Simulation noted_simulation() {
  return Simulation(test::edge_crack(12e6), test::numerics(2e-3, 6e-3), {1});
}

TEST(JournalOfARun, SaysWhatWasDoneInItsOrder) {
  Simulation simulation = noted_simulation();
  Journal journal;
  EXPECT_EQ(journal.take(simulation), "");
  simulation.step();
  journal.changed_loads(simulation);
  journal.came_to_rest(simulation, 1e-7);
  journal.loads_slowly(simulation, {3e-6, 4, 1e-5});
  journal.looked();
  journal.looked();
  const std::vector<Deed> deeds = deeds_in(journal.take(simulation));
  ASSERT_EQ(deeds.size(), 4U);
  EXPECT_EQ(deeds[0].step, 1);
  EXPECT_EQ(std::get<ChangedLoads>(deeds[0].what).loads.tractions.size(), 2U);
  EXPECT_EQ(std::get<CameToRest>(deeds[1].what).tolerance, 1e-7);
  EXPECT_EQ(std::get<LoadedSlowly>(deeds[2].what).end, 3e-6);
  EXPECT_EQ(std::get<LoadedSlowly>(deeds[2].what).increments, 4);
  EXPECT_TRUE(std::holds_alternative<Recorded>(deeds[3].what));
  EXPECT_EQ(deeds[3].look, 1);
  journal.ended_slowly(simulation);
  const std::vector<Deed> after = deeds_in(journal.take(simulation));
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(std::get<EndedSlowly>(after[0].what).looks, 2);
}

TEST(JournalOfARun, BeginsWithTheSlowLoadingThatGoesOn) {
  const Simulation simulation = noted_simulation();
  Journal journal;
  journal.came_to_rest(simulation, 1e-7);
  journal.loads_slowly(simulation, {3e-6, 4, 1e-5});
  journal.looked();
  journal.begin();
  const std::vector<Deed> deeds = deeds_in(journal.take(simulation));
  ASSERT_EQ(deeds.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<LoadedSlowly>(deeds[0].what));
  EXPECT_EQ(deeds[1].look, 0);
}

TEST(JournalOfARun, SaysWhenItCannotHoldMoreAndWhatLoadsAreThenInForce) {
  const Simulation simulation = noted_simulation();
  Journal journal;
  for (int k = 0; k < 10'001; ++k) journal.came_to_rest(simulation, 1e-7);
  const std::vector<Deed> deeds = deeds_in(journal.take(simulation));
  ASSERT_EQ(deeds.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<NotNoted>(deeds[0].what));
  EXPECT_EQ(std::get<ChangedLoads>(deeds[1].what).loads.tractions.size(), 2U);
}

TEST(JournalOfARun, RefusesAnotherText) {
  for (const char* text : {"[", "{}x", "[{}]", R"([{"did":"relax","step":-1,"tolerance":1}])",
                           R"([{"did":"quasistatic","step":1,"end_s":1,"increments":0}])"})
    EXPECT_ANY_THROW(deeds_in(text)) << text;
}

TEST(FunctionsOfARun, AreNamed) {
  Plate plate = test::edge_crack(12e6);
  EXPECT_TRUE(functions_in(inputs_of(plate, test::numerics())).empty());
  plate.loads.tractions[1].amplitude = Amplitude([](double t) { return t; }, "of t");
  EXPECT_THAT(functions_in(inputs_of(plate, test::numerics())),
              testing::ElementsAre("tractions 2 time"));
}

}  // namespace
}  // namespace hackle
