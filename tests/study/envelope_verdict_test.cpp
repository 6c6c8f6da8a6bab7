// SPDX-License-Identifier: MIT
// Verdicts on ends that are made up.
#include "study/envelope_verdict.hpp"

#include <set>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "study/envelope_map.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

Json told_result() {
  return {{"residual_share", 0.01},
          {"notes", Json::array()},
          {"energy_J_per_m", {{"kinetic", 1.0}}},
          {"expectations", Json::array({{{"quantity", "way"},
                                         {"got", 1.0},
                                         {"expected", nullptr},
                                         {"tolerance", nullptr},
                                         {"verdict", "pass"}}})}};
}

Outcome finished_with(Json told) {
  return {.setting = {}, .state = CaseState::finished, .told = std::move(told)};
}

Outcome ended_with(int code, const std::string& message) {
  return {.setting = {}, .state = CaseState::failed, .exit_code = code, .reason = message};
}

CellEnd end_of(const Outcome& outcome, Demand demand = Demand::any) {
  return verdict_of(outcome, demand).end;
}

TEST(EnvelopeVerdict, IsRightIfEveryCheckPasses) {
  EXPECT_EQ(end_of(finished_with(told_result()), Demand::right), CellEnd::right);
  EXPECT_EQ(end_of(finished_with(told_result()), Demand::stopped), CellEnd::failed);
  Json wrong = told_result();
  wrong["expectations"][0]["verdict"] = "fail";
  EXPECT_EQ(end_of(finished_with(wrong)), CellEnd::failed);
  Json blind = told_result();
  blind["expectations"] = Json::array();
  EXPECT_THAT(verdict_of(finished_with(blind), Demand::any).why, HasSubstr("checks nothing"));
}

TEST(EnvelopeVerdict, FailsWhereANumberIsNotFinite) {
  Json told = told_result();
  told["energy_J_per_m"]["kinetic"] = nullptr;
  EXPECT_EQ(verdict_of(finished_with(told), Demand::any).why,
            "energy_J_per_m.kinetic is no finite number");
  told = told_result();
  told["account"] = Json::array({"The ledger of energy closes to nan %."});
  EXPECT_EQ(end_of(finished_with(told)), CellEnd::failed);
  told["account"] = Json::array({"An infant and a nanometre."});
  EXPECT_EQ(end_of(finished_with(told)), CellEnd::right);
  EXPECT_EQ(end_of(finished_with(nullptr)), CellEnd::failed);
}

TEST(EnvelopeVerdict, FailsWhereEnergyIsLostUnsaid) {
  Json told = told_result();
  told["residual_share"] = -0.06;
  EXPECT_THAT(verdict_of(finished_with(told), Demand::any).why, HasSubstr("6 % of the energy"));
  told["notes"].push_back("the energies do not add up: 6 % of the largest is lost");
  EXPECT_EQ(end_of(finished_with(told)), CellEnd::right);
  // Of several simulations each is looked at.
  Json several = told_result();
  Json lossy = told_result();
  lossy["residual_share"] = 0.5;
  several["simulations"] = Json::array({lossy, told_result()});
  EXPECT_EQ(end_of(finished_with(several)), CellEnd::failed);
}

TEST(EnvelopeVerdict, OfARefusalNeedsARemedy) {
  const std::string message = "simulate: spacing is nan, expected a finite number in m";
  EXPECT_EQ(end_of(ended_with(4, message), Demand::refused), CellEnd::refused);
  EXPECT_EQ(end_of(ended_with(4, message), Demand::right), CellEnd::failed);
  EXPECT_EQ(end_of(ended_with(4, "no")), CellEnd::failed);
}

TEST(EnvelopeVerdict, OfAStopNeedsTimeAndPlace) {
  const std::string whole =
      "the solution has diverged by step 64, at 26.67 us, at (0.5 mm, 5.5 mm): the step is long";
  EXPECT_EQ(end_of(ended_with(1, whole), Demand::stopped), CellEnd::stopped);
  EXPECT_EQ(end_of(ended_with(1, "the solution has diverged at 26.67 us")), CellEnd::failed);
  EXPECT_EQ(end_of(ended_with(1, "it diverged at (0.5 mm, 5.5 mm)")), CellEnd::failed);
  // A function of the script that fails in the middle of a run.
  const std::string later =
      "a.lua:34: traction: the function returns nan at t = 10 us (it must return a finite number)";
  EXPECT_EQ(end_of(ended_with(4, later), Demand::stopped), CellEnd::stopped);
  EXPECT_EQ(end_of(ended_with(4, later), Demand::unlike), CellEnd::stopped);
}

TEST(EnvelopeVerdict, FailsForCrashesAndHangs) {
  EXPECT_EQ(verdict_of(ended_with(139, ""), Demand::any).why, "signal 11 ended it");
  EXPECT_EQ(end_of(ended_with(2, "there is no option")), CellEnd::failed);
  EXPECT_EQ(end_of({.setting = {}, .state = CaseState::stopped, .reason = "stopped after 60 s"}),
            CellEnd::failed);
}

TEST(EnvelopeCells, AreAllCombinationsOfTheirWords) {
  const auto cells = expanded("step", "share=0.2|0.4 way=\"at once\"|ramp");
  ASSERT_EQ(cells.size(), 4U);
  EXPECT_EQ(cells[1].name, "share=0.2 way=ramp");
  EXPECT_EQ(cells[2].settings, (Settings{{"share", "0.4"}, {"way", "at once"}}));
}

TEST(EnvelopeCells, AreManyAndDiffer) {
  const auto all = envelope_cells({}, false), quick = envelope_cells({}, true);
  EXPECT_GE(all.size(), 250U);
  EXPECT_LT(quick.size(), all.size());
  std::set<std::string> names;
  for (const EnvelopeCell& cell : all)
    EXPECT_TRUE(names.insert(std::string(cell.family) + " " + cell.name).second) << cell.name;
  for (const EnvelopeCell& cell : quick) EXPECT_FALSE(cell.heavy) << cell.name;
  EXPECT_THROW(envelope_cells({"spn"}, false), Error);
}

TEST(EnvelopeMap, ShowsEveryCellAndRepeatsWhatFails) {
  EnvelopeCell cell = expanded("spin", "share=0.3")[0];
  const std::vector<CellResult> results{{cell, {CellEnd::right, ""}, 0.1},
                                        {cell, {CellEnd::failed, "it turns"}, 0.1}};
  EXPECT_THAT(text_map(results),
              testing::AllOf(HasSubstr("spin          +X  2\n"), HasSubstr("1 failed (X)"),
                             HasSubstr("it turns"),
                             HasSubstr("hackle run scripts/envelope/spin.lua --set share=0.3")));
  EXPECT_EQ(picture_map(results).width, 720);
}

TEST(EnvelopeMap, IsAsWideAsItsCellsAndNoWider) {
  std::vector<CellResult> results;
  for (const EnvelopeCell& cell : envelope_cells({}, false))
    results.push_back({cell, {CellEnd::right, ""}, 0.1});
  const Image map = picture_map(results);
  EXPECT_GT(map.width, 1000);
  EXPECT_LE(map.width, 1280);
  // At least a line of squares for each family and for what does not fit into one.
  EXPECT_GT(map.height, static_cast<int>(envelope_families().size()) * 39);
}

}  // namespace
}  // namespace hackle
