// SPDX-License-Identifier: MIT
// Convergence of a scene whose errors are known: see fake_hackle.cpp.
#include "study/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "study/convergence_files.hpp"
#include "study/convergence_report.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::Contains;
using testing::HasSubstr;

class ConvergenceTest : public testing::Test {
 protected:
  ConvergenceStudy studied(const std::string& model, ConvergenceOptions options = {}) {
    const auto script = folder_.path / "scene.lua";
    write_text(script, model);
    CaseRunner runner({.program = FAKE_HACKLE, .path = script, .settings = {}, .arguments = {}},
                      {.folder = folder_.path / "study", .threads = 2, .talk = Talk::quiet});
    return convergence(runner, options);
  }
  static const QuantityConvergence& of(const ConvergenceStudy& study, RefinedBy by,
                                       const std::string& name) {
    const auto axis = std::ranges::find(study.axes, by, &ConvergenceAxis::by);
    const auto one = std::ranges::find(
        axis->quantities, name, [](const QuantityConvergence& each) { return each.row.name; });
    EXPECT_NE(one, axis->quantities.end()) << name;
    return *one;
  }

  test::Folder folder_;
};

TEST_F(ConvergenceTest, FindsOrderAndLimit) {
  for (const auto& [model, order] :
       {std::pair(R"({"a": 4, "p": 1})", 1.0), std::pair(R"({"a": 4000, "p": 2})", 2.0)}) {
    const ConvergenceStudy study = studied(model);
    const auto& energy = of(study, RefinedBy::delta, "energy.broken");
    EXPECT_NEAR(*energy.order.order, order, 1e-6);
    EXPECT_NEAR(*energy.limit, 2.0, 1e-9);
    const double error = 4.0 * std::pow(1000.0, order - 1.0) * std::pow(0.5e-3, order);
    EXPECT_NEAR(*energy.gci, 1.25 * error / (2.0 + error), 1e-9);
    const auto& place = of(study, RefinedBy::delta, "fork.place");
    EXPECT_NEAR(*place.order.order, order, 1e-6);
    EXPECT_NEAR(place.place->x(), 0.06, 1e-9);
    EXPECT_NEAR(place.place->y(), 0.02, 1e-9);
    EXPECT_NEAR(*of(study, RefinedBy::m, "energy.broken").limit, 2.0, 1e-6);
  }
}

TEST_F(ConvergenceTest, SeesWhatTheStepDoesNotChange) {
  const ConvergenceStudy study = studied(R"({"a": 4})");
  EXPECT_EQ(of(study, RefinedBy::step, "fork.place").order.trend, Trend::constant);
  const auto& residual = of(study, RefinedBy::step, "residual");
  EXPECT_NEAR(*residual.order.order, 1.0, 1e-6);
  EXPECT_NEAR(*residual.limit, 0.0, 1e-12);
}

TEST_F(ConvergenceTest, SaysWhatDoesNotConvergeAndHow) {
  const ConvergenceStudy study = studied(R"({"a": 1000, "p": -0.5})");
  const auto& energy = of(study, RefinedBy::delta, "energy.broken");
  EXPECT_EQ(energy.order.trend, Trend::diverges);
  EXPECT_NEAR(*energy.exponent, -0.5, 1e-4);
  EXPECT_FALSE(energy.gci);
  EXPECT_THAT(remarks_of(study.axes.front()),
              Contains(HasSubstr("energy.broken does not converge: it moves by")));
  EXPECT_THAT(remarks_of(study.axes.front()), Contains(HasSubstr("as horizon^-0.50")));
  EXPECT_THAT(text_of(study), HasSubstr("diverges"));
}

TEST_F(ConvergenceTest, LeavesOutWhatCostsTooMuch) {
  const ConvergenceStudy study = studied("{}", {.budget = 0.0});
  EXPECT_EQ(study.axes[0].levels.size(), 2U);  // coarser, and as written
  ASSERT_EQ(study.axes[0].left_out.size(), 1U);
  EXPECT_EQ(study.axes[0].left_out[0].name, "2 mm");
  EXPECT_THAT(remarks_of(study.axes[0]), Contains(HasSubstr("left out: 2 mm")));
  EXPECT_EQ(study.axes[1].levels.size(), 2U);  // m = 3 and 4
}

TEST_F(ConvergenceTest, FollowsLevelsRatioAndAxes) {
  const ConvergenceStudy study =
      studied("{}", {.axes = {RefinedBy::delta}, .levels = 4, .ratio = 1.5});
  ASSERT_EQ(study.axes.size(), 1U);
  ASSERT_EQ(study.axes[0].levels.size(), 4U);
  for (std::size_t k = 1; k < 4; ++k)
    EXPECT_NEAR(study.axes[0].levels[k - 1].size / study.axes[0].levels[k].size, 1.5, 1e-12);
}

TEST_F(ConvergenceTest, SetsOptionsOfTheScriptThatAreNamedAlike) {
  const ConvergenceStudy study =
      studied("{}", {.axes = {RefinedBy::delta}, .declared = {"horizon", "load"}});
  const Settings& settings = study.axes[0].levels[0].outcome.setting.settings;
  EXPECT_EQ(settings.at("horizon"), settings.at("simulate.horizon"));
  EXPECT_FALSE(settings.contains("spacing"));
}

TEST_F(ConvergenceTest, GoesOnWithoutWhatFails) {
  const ConvergenceStudy study = studied(R"({"fails": "simulate.safety"})");
  EXPECT_EQ(study.axes[2].failed.size(), 3U);
  EXPECT_THAT(remarks_of(study.axes[2]), Contains(HasSubstr("this cannot be")));
}

TEST_F(ConvergenceTest, TellsProgramsTheSame) {
  const ConvergenceStudy study =
      studied(R"({"a": 4})", {.quantities = quantities_named({"fork.time", "tip.path"})});
  const auto json = to_json(study);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["kind"], "convergence");
  ASSERT_EQ(json["axes"].size(), 3U);
  const auto& axis = json["axes"][0];
  EXPECT_EQ(axis["axis"], "delta");
  EXPECT_EQ(axis["levels"].size(), 3U);
  ASSERT_EQ(axis["quantities"].size(), 2U);
  const auto& time = axis["quantities"]["fork.time"];
  for (const char* key : {"values", "order", "richardson", "gci", "verdict"})
    EXPECT_TRUE(time.contains(key)) << key;
  EXPECT_EQ(time["verdict"], "converges");
  EXPECT_NEAR(time["richardson"].get<double>(), 1e-5, 1e-12);
  // Of a path, how far it is from the finest.
  EXPECT_NEAR(axis["quantities"]["tip.path"]["values"][0].get<double>(), 4.0 * 1.5e-3, 1e-9);
  const StudyFindings findings = findings_of(study);
  EXPECT_EQ(findings.table.rows.size(), 2U * (3U + 4U + 3U));
  EXPECT_THAT(findings.diagram_names, Contains("delta-error"));
  EXPECT_THAT(findings.diagram_names, Contains("delta-places"));
}

Level level_with(double size, const nlohmann::ordered_json& told) {
  return {{.state = CaseState::finished, .told = told}, size, "", 1e-9, 1e-9};
}

TEST(Judged, SaysWhereAQuantityIsMissing) {
  const nlohmann::ordered_json with{{"first_break", {{"time_s", 1e-6}}}}, without{{"events", {}}};
  const QuantityRow row = *quantity_named("first_bond.time");
  const auto found =
      judged({level_with(4, without), level_with(2, with), level_with(1, with)}, row);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->order.trend, Trend::missing);
  EXPECT_FALSE(judged({level_with(2, without), level_with(1, without)}, row));
}

TEST(Judged, KnowsTheReasonOfAStrengthWithoutACrack) {
  std::vector<Level> levels;
  for (const double size : {4e-3, 2e-3, 1e-3})
    levels.push_back(level_with(size, {{"first_break", {{"time_s", 1e-6 / std::sqrt(size)}}}}));
  ConvergenceAxis axis;
  axis.quantities.push_back(*judged(levels, *quantity_named("first_bond.time")));
  axis.levels = levels;
  EXPECT_THAT(remarks_of(axis), Contains(HasSubstr("goes with 1/sqrt(horizon)")));
}

}  // namespace
}  // namespace hackle
