// SPDX-License-Identifier: MIT
// Fits to a scene whose results are known: see fake_hackle.cpp.
#include "study/fit.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/files.hpp"
#include "study/fit_report.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::Contains;
using testing::HasSubstr;

class FitTest : public testing::Test {
 protected:
  FitResult fitted(const std::string& model, const FitOptions& options) {
    const auto script = folder_.path / "scene.lua";
    write_text(script, model);
    CaseRunner runner({.program = FAKE_HACKLE, .path = script, .settings = {}, .arguments = {}},
                      {.folder = folder_.path / "study", .threads = 2, .talk = Talk::quiet});
    return fit(runner, options);
  }
  test::Folder folder_;
};

TEST_F(FitTest, FindsTwoParameters) {
  // Broken energy 2 + 10 dx tells dx, the fork at 0.06 + 10 dx + 1e-3 E then tells E.
  const double dx = 2e-3, E = 7.0;
  FitOptions options{.parameters = {ranged_parameter_of("material.E=0:20"),
                                    ranged_parameter_of("simulate.spacing=1e-3:5e-3")},
                     .measurements = {measurement_of("energy.broken=2.02"),
                                      measurement_of("fork.place=87mm,20mm")}};
  options.measurements[0].sigma = 1e-4;
  options.measurements[1].sigma = 1e-3;
  const FitResult found = fitted(R"({"a": 10, "chaos": 1e-3})", options);
  EXPECT_NEAR(found.parameters[0].value, E, 1e-3);
  EXPECT_NEAR(found.parameters[1].value, dx, 1e-6);
  // dx: 1e-4/10; E: sqrt(1e-3^2 + 1e-4^2)/1e-3.
  EXPECT_NEAR(*found.parameters[1].uncertainty, 1e-5, 1e-7);
  EXPECT_NEAR(*found.parameters[0].uncertainty, 1.005, 1e-2);
  EXPECT_LT(std::abs(*found.residuals[0].residual), 1e-2);
  EXPECT_EQ(found.degrees_of_freedom, 1);
  EXPECT_TRUE(found.converged);
}

// The fork is at 0.06 + 1e-3 |E|: 80 mm are those of E = -20 and of 20.
TEST_F(FitTest, TellsOfASecondValley) {
  const FitResult found = fitted(R"({"a": 0, "valleys": 1e-3})",
                                 {.parameters = {ranged_parameter_of("material.E=-50:40")},
                                  .measurements = {measurement_of("fork.place=80mm,20mm")}});
  EXPECT_NEAR(std::abs(found.parameters[0].value), 20.0, 0.2);
  ASSERT_EQ(found.valleys.size(), 1U);
  const double other = std::stod(found.valleys[0].settings.at("material.E"));
  EXPECT_NEAR(other, -found.parameters[0].value, 0.5);
  EXPECT_THAT(remarks_of(found), Contains(HasSubstr("another valley fits about as well")));
}

TEST_F(FitTest, FollowsAPath) {
  const auto file = folder_.path / "path.csv";
  write_text(file, "x_mm,y_mm\n50,20\n60,20\n66,20\n");
  const FitResult found = fitted(R"({"a": 0, "chaos": 1e-3})",
                                 {.parameters = {ranged_parameter_of("material.E=0:20")},
                                  .measurements = {measurement_of("tip.path=" + file.string()),
                                                   measurement_of("crack.length=16mm")}});
  EXPECT_NEAR(found.parameters[0].value, 6.0, 1e-2);
}

TEST_F(FitTest, SaysWhatDoesNotReact) {
  const FitResult found = fitted(
      R"({"a": 0, "chaos": 1e-3})",
      {.parameters = {ranged_parameter_of("material.E=0:20"), ranged_parameter_of("load=1:2MPa")},
       .measurements = {measurement_of("fork.time=20us"), measurement_of("branches=1")}});
  EXPECT_NEAR(found.parameters[0].value, 10.0, 0.05);
  EXPECT_FALSE(found.parameters[1].reacts);
  EXPECT_THAT(remarks_of(found), Contains(HasSubstr("reacts to load")));
  EXPECT_THAT(remarks_of(found), Contains(HasSubstr("branches does not react to material.E")));
}

TEST_F(FitTest, SaysWhenABoundIsInTheWay) {
  const FitResult found =
      fitted(R"({"a": 0, "chaos": 1e-3})", {.parameters = {ranged_parameter_of("material.E=0:5")},
                                            .measurements = {measurement_of("fork.time=20us")}});
  EXPECT_TRUE(found.parameters[0].at_bound);
  EXPECT_THAT(remarks_of(found), Contains(HasSubstr("widen it")));
  EXPECT_THAT(remarks_of(found), Contains(HasSubstr("sigma off")));
}

TEST_F(FitTest, RefusesWhatNoRunFinds) {
  EXPECT_THROW(fitted("{}", {.parameters = {ranged_parameter_of("material.E=0:5")},
                             .measurements = {measurement_of("arrival.time=20us")}}),
               Error);
}

TEST_F(FitTest, TellsProgramsTheSame) {
  const FitResult found =
      fitted(R"({"a": 0, "chaos": 1e-3})", {.parameters = {ranged_parameter_of("material.E=0:20")},
                                            .measurements = {measurement_of("fork.time=20us")}});
  const auto json = to_json(found);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["kind"], "fit");
  EXPECT_NEAR(json["parameters"]["material.E"]["value"].get<double>(), 10.0, 0.05);
  EXPECT_TRUE(json["residuals"].contains("fork.time"));
  EXPECT_EQ(json["runs"], found.runs);
  EXPECT_EQ(findings_of(found).table.rows.size(), 1U);
}

TEST(Measurement, ReadsNumbersPlacesAndPaths) {
  EXPECT_DOUBLE_EQ(*measurement_of("fork.time=22us").value.number, 22e-6);
  const Vec2 place = *measurement_of("fork.place=67,20mm").value.place;
  EXPECT_NEAR((place - Vec2(0.067, 0.02)).norm(), 0.0, 1e-15);
  const test::Folder folder;
  for (const char* head : {"x,y", "y (m), x (m)", "t,x_m,y_m"}) {
    const auto file = folder.path / "p.csv";
    write_text(file, std::string(head) + "\n0.01,0.01,0.01\n0.02,0.02,0.02\n");
    EXPECT_EQ(measurement_of("tip.path=" + file.string()).value.paths.front().size(), 2U) << head;
  }
  for (const char* word : {"fork.time", "fork.tmie=2us", "fork.time=soon", "fork.place=67mm",
                           "displacement=1", "tip.path=none.csv"})
    EXPECT_THROW(measurement_of(word), Error) << word;
}

TEST(Measurement, HasResidualsInSigmas) {
  Measurement time = measurement_of("first_bond.time=2us");
  const Outcome outcome{.state = CaseState::finished,
                        .told = {{"first_break", {{"time_s", 3e-6}, {"place_m", {0.0, 0.001}}}}}};
  EXPECT_NEAR((*time.residuals(outcome, 0.5e-6))[0], 2.0, 1e-12);
  const auto place = measurement_of("first_bond.place=0,0m").residuals(outcome, 1e-3);
  EXPECT_NEAR((*place)[0], 0.0, 1e-12);
  EXPECT_NEAR((*place)[1], 1.0, 1e-12);
  EXPECT_FALSE(measurement_of("fork.time=2us").residuals(outcome, 1.0));
}

TEST(Measurement, SetsSigmas) {
  std::vector<Measurement> all{measurement_of("fork.time=2us")};
  set_sigma(all, "fork.time=0.1us");
  EXPECT_DOUBLE_EQ(*all[0].sigma, 0.1e-6);
  EXPECT_THROW(set_sigma(all, "fork.place=1mm"), Error);
  EXPECT_THROW(set_sigma(all, "fork.time=0s"), Error);
  EXPECT_THROW(set_sigma(all, ""), Error);
}

}  // namespace
}  // namespace hackle
