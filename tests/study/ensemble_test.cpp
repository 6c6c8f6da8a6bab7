// SPDX-License-Identifier: MIT
#include "study/ensemble.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "study/ensemble_report.hpp"
#include "study/told_runs.hpp"

namespace hackle {
namespace {

using test::told_run;
using testing::HasSubstr;

const SceneNumerics scene{.spacing = 5e-4, .horizon = 2e-3, .duration = 50e-6};

// All alike until 20 us, at 60 mm; then two branches of one angle or the other, and one run does
// not branch.
std::vector<Outcome> runs_of_three() {
  return {told_run({{50, 20, 60, 20, 10, 20}, {60, 20, 80, 30, 20, 40}, {60, 20, 80, 10, 20, 40}}),
          told_run({{50, 20, 60, 20, 10, 20}, {60, 20, 80, 25, 20, 40}, {60, 20, 80, 15, 20, 40}}),
          told_run({{50, 20, 60, 20, 10, 20}, {60, 20, 80, 20, 20, 40}})};
}

const QuantityStatistic& named(const Ensemble& all, std::string_view name) {
  for (const QuantityStatistic& one : all.quantities)
    if (one.row.name == name) return one;
  throw Error(ErrorKind::refused, "no such quantity");
}

TEST(Ensemble, FindsWhenRunsPartAndHowFarTheyAreApart) {
  const Ensemble all = ensemble_of(scene, {.runs = 3}, runs_of_three());
  ASSERT_TRUE(all.parting);
  // 2 mm from the middle line: 0.2 of the way of the steepest branch, which has points each 1/40.
  EXPECT_NEAR(all.parting->time, 24.5e-6, 0.6e-6);
  EXPECT_NEAR(all.apart, 10e-3, 0.5e-3);
  EXPECT_TRUE(all.is_chaotic());
  EXPECT_THAT(verdict_of(all), HasSubstr("Chaotic from 24"));
}

TEST(Ensemble, KnowsWhichNumbersOneRunTells) {
  const Ensemble all = ensemble_of(scene, {.runs = 3}, runs_of_three());
  EXPECT_TRUE(named(all, "fragments").is_settled());
  EXPECT_FALSE(named(all, "branches").is_settled());
  EXPECT_NEAR(named(all, "branches").statistic.mean, 8.0 / 3.0, 1e-12);
  EXPECT_NEAR(named(all, "fragments.largest").statistic.mean, 3e-3, 1e-12);
  EXPECT_NEAR(named(all, "fragments.median").statistic.mean, 3e-3, 1e-12);
  EXPECT_THAT(verdict_of(all), HasSubstr("Only the distribution means something: branches"));
}

TEST(Ensemble, IsNotChaoticIfRunsAgreeToTheEnd) {
  const Outcome one = told_run({{50, 20, 60, 20, 10, 20}});
  const Outcome near = told_run({{50, 20.5, 60, 20.5, 10, 20}});
  const Ensemble all = ensemble_of(scene, {.runs = 2}, {one, near});
  EXPECT_FALSE(all.parting);
  EXPECT_NEAR(all.apart, 0.5e-3, 1e-9);
  EXPECT_FALSE(all.is_chaotic());
  EXPECT_TRUE(ensemble_of(scene, {.runs = 2, .within = 0.4e-3}, {one, near}).is_chaotic());
}

TEST(Ensemble, SaysHowFarTheLastBitsWereChanged) {
  const Ensemble bits = ensemble_of(scene, {.runs = 3}, runs_of_three());
  EXPECT_DOUBLE_EQ(bits.size, 2.0 * std::ldexp(1.0, -22));
  SceneNumerics doubles = scene;
  doubles.precision = "f64";
  doubles.E = 65e9;
  const Ensemble all = ensemble_of(doubles, {.runs = 3}, runs_of_three());
  EXPECT_DOUBLE_EQ(all.size, 2.0 * std::ldexp(1.0, -50));
  EXPECT_THAT(verdict_of(all), HasSubstr("a change of the last bits of E by at most 1.8e-15"));
  EXPECT_THAT(verdict_of(ensemble_of(doubles, {.runs = 3, .size = 1e-5}, runs_of_three())),
              HasSubstr("a change of E by at most 1e-05"));
}

TEST(Ensemble, ChangesNothingButTheLastBits) {
  SceneNumerics doubles = scene;
  doubles.precision = "f64";
  doubles.E = 65e9;
  for (int number = 1; number <= 32; ++number) {
    const double changed = std::stod(last_bits(doubles, number).at("material.E"));
    EXPECT_GT(changed, 65e9);
    EXPECT_LE(changed / 65e9 - 1.0, 32.5 * std::ldexp(1.0, -50));
  }
}

TEST(Ensemble, CallsFlawsThatMoveCracksNoChaos) {
  const Ensemble all =
      ensemble_of(scene, {.runs = 3, .change = Change::strength, .size = 0.01}, runs_of_three());
  EXPECT_FALSE(all.is_chaotic());
  EXPECT_THAT(verdict_of(all), HasSubstr("Sensitive from"));
  EXPECT_THAT(verdict_of(all), HasSubstr("a scatter of strength of 1 %"));
}

TEST(Ensemble, TellsOfRunsThatFailedAndNeedsTwo) {
  std::vector<Outcome> runs = runs_of_three();
  runs[1] = Outcome{.reason = "it diverged"};
  const Ensemble all = ensemble_of(scene, {.runs = 3}, runs);
  EXPECT_EQ(all.runs.size(), 2U);
  EXPECT_THAT(verdict_of(all), HasSubstr("it diverged"));
  runs[2] = runs[1];
  EXPECT_THROW(ensemble_of(scene, {.runs = 3}, runs), Error);
}

TEST(Ensemble, TellsProgramsTheSame) {
  const auto json = to_json(ensemble_of(scene, {.runs = 3}, runs_of_three()));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["kind"], "ensemble");
  EXPECT_EQ(json["runs"], 3);
  EXPECT_DOUBLE_EQ(json["agree_within_m"].get<double>(), 2e-3);
  EXPECT_NEAR(json["agree_until_s"].get<double>(), 24.5e-6, 0.6e-6);
  for (const char* key : {"mean", "sd", "low", "high", "min", "max"})
    EXPECT_TRUE(json["quantities"]["branches"].contains(key)) << key;
}

TEST(Ensemble, HasARowForEachRun) {
  const Table table = table_of(ensemble_of(scene, {.runs = 3}, runs_of_three()));
  ASSERT_EQ(table.rows.size(), 3U);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.heads.size());
}

}  // namespace
}  // namespace hackle
