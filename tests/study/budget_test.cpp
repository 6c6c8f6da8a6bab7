// SPDX-License-Identifier: MIT
// The error budget of a scene whose errors are known: the fork of fake_hackle.cpp is off by a dx^p.
#include "study/budget.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// Of an error in proportion to the spacing: it is half a spacing, and spacings that differ by
// factors of 3/4 and 2/3 are a third or a half of the finer one apart.
const BudgetCalibration of_first_order{
    .of_same = 1.5, .of_coarser = 2.0, .levels = {{3.0, 0.5}, {6.0, 0.1}}};

class BudgetTest : public testing::Test {
 protected:
  ErrorBudget spent(const std::string& model, const BudgetOptions& options,
                    const BudgetCalibration& calibration = of_first_order) const {
    const auto script = folder_.path / "scene.lua";
    write_text(script, model);
    CaseRunner runner({.program = FAKE_HACKLE, .path = script, .settings = {}, .arguments = {}},
                      {.folder = folder_.path / "study", .threads = 2, .talk = Talk::quiet});
    return budget_by_trials(runner, calibration, options);
  }
  test::Folder folder_;
};

TEST_F(BudgetTest, KeepsTheBudgetAndExpectsAtLeastWhatIsMeasured) {
  for (const double within : {1.0e-3, 0.7e-3, 0.51e-3, 0.34e-3}) {
    const ErrorBudget budget =
        spent(R"({"a": 1.0, "p": 1})", {.within = within, .verify = true, .horizon = 4e-3});
    EXPECT_TRUE(budget.is_met()) << within;
    ASSERT_TRUE(budget.measured);
    EXPECT_NEAR(*budget.measured, 0.5 * budget.spacing, 1e-9);
    EXPECT_LE(*budget.measured, *budget.expected * (1.0 + 1e-9));
    EXPECT_LE(*budget.expected, within);
  }
}

TEST_F(BudgetTest, TakesACoarserSpacingForALargerBudget) {
  const auto spacing = [&](double within) {
    return spent(R"({"a": 1.0, "p": 1})", {.within = within, .horizon = 4e-3}).spacing;
  };
  EXPECT_NEAR(spacing(2e-3), 2e-3, 1e-9);
  EXPECT_NEAR(spacing(0.7e-3), 1e-3, 0.34e-3);
  EXPECT_LT(spacing(0.4e-3), spacing(0.7e-3));
}

TEST_F(BudgetTest, SaysThatNoSettingKeepsIt) {
  const ErrorBudget budget = spent(R"({"a": 1.0, "p": 1})", {.within = 1e-6, .horizon = 4e-3});
  EXPECT_FALSE(budget.is_met());
  EXPECT_NEAR(budget.spacing, 0.5e-3, 1e-9);
  EXPECT_THAT(describe(budget), HasSubstr("no setting is expected to keep it"));
}

// Of first order with a small factor: trials agree to far less than a horizon.
TEST_F(BudgetTest, PromisesNoLessThanAHorizon) {
  BudgetCalibration calibration = of_first_order;
  calibration.least = 1.0;
  const auto budget_for = [&](double within) {
    return spent(R"({"a": 0.1, "p": 1})", {.within = within, .horizon = 4e-3}, calibration);
  };
  const ErrorBudget small = budget_for(2e-3), enough = budget_for(4e-3);
  EXPECT_FALSE(small.is_met());
  EXPECT_NEAR(*small.expected, 4e-3, 1e-12);
  EXPECT_THAT(describe(small), HasSubstr("hardly determined to less than a horizon"));
  EXPECT_TRUE(enough.is_met());
  EXPECT_NEAR(small.spacing, enough.spacing, 1e-12) << "finer would be no surer";
}

TEST_F(BudgetTest, RefinesAHorizonThatFollows) {
  BudgetCalibration calibration = of_first_order;
  calibration.least = 1.0;
  const ErrorBudget budget =
      spent(R"({"a": 0.1, "p": 1})", {.within = 2e-3, .side = 0.04}, calibration);
  EXPECT_TRUE(budget.is_met());
  EXPECT_LE(4.0 * budget.spacing, 2e-3 * (1.0 + 1e-9)) << "a horizon of four spacings";
  EXPECT_GT(4.0 * budget.spacing, 1e-3);
}

TEST_F(BudgetTest, StatesNoNumberWhereItIsChaotic) {
  // The fifth digit of 65 GPa moves the fork by 2 mm.
  const ErrorBudget budget =
      spent(R"({"a": 0.1, "p": 1, "chaos": 3e-9})", {.within = 1e-3, .horizon = 4e-3});
  EXPECT_TRUE(budget.chaotic);
  EXPECT_FALSE(budget.expected);
  EXPECT_FALSE(budget.is_met());
  EXPECT_THAT(describe(budget), HasSubstr("chaotic"));
}

TEST_F(BudgetTest, TriesNothingCoarserThanTheScriptAllows) {
  const BudgetOptions options{.within = 1.0, .horizon = 4e-3, .max_spacing = 1e-3};
  EXPECT_LE(budget_spacings(options).front(), 1e-3);
  EXPECT_LE(spent(R"({"a": 1.0})", options).spacing, 1e-3);
}

TEST(Budget, WithoutTrialsTakesTheCalibration) {
  const BudgetOptions options{.within = 0.5e-3, .horizon = 4e-3};
  const ErrorBudget budget = budget_from(of_first_order, options);
  EXPECT_NEAR(budget.spacing, 4e-3 / 6.0, 1e-9);
  EXPECT_NEAR(*budget.expected, 0.1 * 4e-3, 1e-12);
  EXPECT_EQ(budget.trials, 0);
  EXPECT_THAT(describe(budget), HasSubstr("calibration alone"));
}

TEST(Budget, WithoutAHorizonDividesTheSideOfThePlate) {
  const std::vector<double> all = budget_spacings({.within = 1e-3, .side = 0.04});
  EXPECT_DOUBLE_EQ(all.front(), 2e-3);
  for (std::size_t k = 2; k < all.size(); ++k) EXPECT_NEAR(all[k - 2], 2.0 * all[k], 1e-12);
}

TEST(Budget, HasACalibration) {
  const BudgetCalibration calibration = budget_calibration();
  EXPECT_GT(calibration.of_same, 0.0);
  EXPECT_GT(calibration.of_coarser, 0.0);
  EXPECT_EQ(calibration.least, 1.0);
  ASSERT_FALSE(calibration.levels.empty());
  for (std::size_t k = 1; k < calibration.levels.size(); ++k)
    EXPECT_GT(calibration.levels[k].m, calibration.levels[k - 1].m);
}

TEST(Budget, TellsProgramsWhatItChose) {
  const auto json = to_json(ErrorBudget{.within = 1e-3, .spacing = 5e-4, .expected = 4e-4});
  EXPECT_EQ(json["within_m"], 1e-3);
  EXPECT_EQ(json["expected_m"], 4e-4);
  EXPECT_TRUE(json["measured_m"].is_null());
  EXPECT_EQ(json["is_met"], true);
}

}  // namespace
}  // namespace hackle
