// SPDX-License-Identifier: MIT
// Sweeps of a scene whose results are known: see fake_hackle.cpp. Its fork is chaos * E later.
#include "study/sweep.hpp"

#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/files.hpp"
#include "study/sweep_files.hpp"
#include "study/sweep_report.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SweepTest : public testing::Test {
 protected:
  Sweep swept(const std::string& model, const SweepOptions& options, int threads = 2) {
    write_text(script_, model);
    CaseRunner runner({.program = FAKE_HACKLE, .path = script_, .settings = {}, .arguments = {}},
                      {.folder = folder_.path / "study", .threads = threads, .talk = Talk::quiet});
    return sweep(runner, options);
  }
  std::size_t calls() const {
    const std::string text = read_text(script_.string() + ".calls");
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
  }
  // The fork comes at (0.06 + 1e-3 E - 0.05)/1000 s.
  static constexpr auto model_ = R"({"a": 0, "chaos": 1e-3})";

  test::Folder folder_;
  std::filesystem::path script_ = folder_.path / "scene.lua";
};

TEST_F(SweepTest, RunsAllCombinations) {
  const Sweep found =
      swept(model_, {.parameters = {parameter_of("material.E=1,2,4"), parameter_of("load=3:5:1"),
                                    parameter_of("fixed=7")},
                     .quantities = quantities_named({"fork.time"})});
  ASSERT_EQ(found.runs.size(), 9U);
  EXPECT_EQ(found.parameters.size(), 2U);
  EXPECT_EQ(found.runs[3].outcome.setting.settings.at("fixed"), "7");
  EXPECT_EQ(*found.runs[3].numbers[0], 2.0);
  EXPECT_EQ(*found.runs[3].numbers[1], 3.0);
  const auto json = to_json(found);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["kind"], "sweep");
  ASSERT_EQ(json["runs"].size(), 9U);
  EXPECT_NEAR(json["runs"][8]["quantities"]["fork.time"].get<double>(), (0.01 + 4e-3) / 1000,
              1e-12);
  EXPECT_TRUE(json["runs"][8].contains("wall_s"));
}

TEST_F(SweepTest, DoesNotRunAgainWhatItHasRun) {
  const SweepOptions options{.parameters = {parameter_of("material.E=1,2,4")}};
  EXPECT_EQ(swept(model_, options).runs_made, 3);
  EXPECT_EQ(swept(model_, options).runs_made, 0);
  EXPECT_EQ(swept(model_, {.parameters = {parameter_of("material.E=1:5:1")}}).runs_made, 2);
  EXPECT_EQ(calls(), 5U);
}

TEST_F(SweepTest, SaysAtOnceWhatFailsEverywhere) {
  const std::string model = R"({"fails": "lod"})";
  EXPECT_THROW(swept(model, {.parameters = {parameter_of("lod=1:9:1")}}), Error);
  EXPECT_EQ(calls(), 2U);
}

TEST_F(SweepTest, DrawsNumbersOverOneParameter) {
  const Sweep found = swept(model_, {.parameters = {parameter_of("material.E=1:3:1")},
                                     .quantities = quantities_named({"fork.time", "fork.place"})});
  const auto charts = charts_of(found);
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_EQ(charts[0].curves[0].points.size(), 3U);
  const StudyFindings findings = findings_of(found, 80);
  EXPECT_THAT(findings.diagram_names, ElementsAre("sweep-fork.time"));
  EXPECT_THAT(findings.table.heads, ElementsAre("material.E", "fork.time_s", "fork.place.x_m",
                                                "fork.place.y_m", "wall_s", "cpu_s", "failed"));
  EXPECT_THAT(findings.text, HasSubstr("12 us"));
}

TEST_F(SweepTest, FindsAThreshold) {
  // 20 us are reached at E = 10.
  const SweepOptions options{.parameters = {parameter_of("material.E=0:37", true)},
                             .threshold = condition_of("fork.time >= 20us"),
                             .tolerance = 1e-3};
  const Sweep found = swept(model_, options);
  ASSERT_TRUE(found.threshold && found.threshold->found());
  EXPECT_NEAR(*found.threshold->holds_at, 10.0, 1e-3);
  EXPECT_NEAR(*found.threshold->fails_at, 10.0, 1e-3);
  EXPECT_GE(*found.threshold->holds_at, 10.0 - 1e-9);
  EXPECT_LT(*found.threshold->fails_at, 10.0);
  EXPECT_EQ(found.runs_made, 2 + 16);  // 37/2^16 < 1e-3
  const Sweep alone = swept(model_, options, 1);
  EXPECT_EQ(alone.runs_made, 0);
  EXPECT_EQ(alone.threshold->holds_at, found.threshold->holds_at);
}

TEST_F(SweepTest, SaysWhenTheEndsDoNotBracketIt) {
  SweepOptions options{.parameters = {parameter_of("material.E=0:5", true)},
                       .threshold = condition_of("fork.time >= 20us")};
  const Sweep never = swept(model_, options);
  EXPECT_FALSE(never.threshold->found());
  EXPECT_THAT(text_of(*never.threshold), HasSubstr("does not hold"));
  options.threshold = condition_of("fork.time < 1s");
  EXPECT_THAT(text_of(*swept(model_, options).threshold), HasSubstr("holds wherever"));
}

TEST_F(SweepTest, LooksAtTheStepsFirst) {
  const Sweep found = swept(model_, {.parameters = {parameter_of("material.E=0:16:4")},
                                     .threshold = condition_of("fork.time >= 19.9us")});
  EXPECT_EQ(found.runs_made, 5 + 4);  // 16/64 is 4/2^4
  EXPECT_EQ(*found.threshold->holds_at, 10.0);
  EXPECT_EQ(*found.threshold->fails_at, 9.75);
  EXPECT_FALSE(found.threshold->several);
}

TEST_F(SweepTest, ThresholdNeedsOneRange) {
  const Condition condition = condition_of("branches >= 2");
  EXPECT_THROW(swept(model_, {.parameters = {parameter_of("a=1")}, .threshold = condition}), Error);
  EXPECT_THROW(swept(model_, {.parameters = {parameter_of("a=1,2")}, .threshold = condition}),
               Error);
  EXPECT_THROW(swept(model_, {.parameters = {parameter_of("a=1:2:1"), parameter_of("b=1:2:1")},
                              .threshold = condition}),
               Error);
  EXPECT_THROW(swept(model_, {.parameters = {parameter_of("a=1"), parameter_of("a=2")}}), Error);
}

TEST(Condition, ReadsAComparison) {
  const Condition fork = condition_of("fork.time<20us");
  EXPECT_EQ(fork.row.name, "fork.time");
  EXPECT_EQ(fork.comparison, Comparison::less);
  EXPECT_DOUBLE_EQ(fork.value, 20e-6);
  EXPECT_EQ(condition_of(" expect.ratio == 2 ").row.name, "expect.ratio");
  for (const char* text :
       {"branches", "branches => 2", "branches >= two", "branhces >= 2", "tip.path > 1", ""})
    EXPECT_THROW(condition_of(text), Error) << text;
}

TEST(Condition, ComparesWhatWasFound) {
  const auto with = [](double time) {
    return Outcome{.state = CaseState::finished, .told = {{"first_break", {{"time_s", time}}}}};
  };
  const auto holds = [&](const std::string& comparison, double time) {
    return condition_of("first_bond.time" + comparison + "2").holds(with(time));
  };
  EXPECT_TRUE(holds("<", 1) && !holds("<", 2));
  EXPECT_TRUE(holds("<=", 2) && !holds("<=", 3));
  EXPECT_TRUE(holds(">", 3) && !holds(">", 2));
  EXPECT_TRUE(holds(">=", 2) && !holds(">=", 1));
  EXPECT_TRUE(holds("==", 2) && !holds("==", 1));
  EXPECT_FALSE(condition_of("fork.time < 1").holds(with(1)));
}

}  // namespace
}  // namespace hackle
