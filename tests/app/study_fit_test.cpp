// SPDX-License-Identifier: MIT
// hackle study fit, as a user meets it.
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/study_plate.hpp"

namespace hackle {
namespace {

using Json = nlohmann::json;

using StudyFitTest = test::StudiedPlate;

// The fit cannot tell loads apart between which its differences, 1/32 of the range, lie.
TEST_F(StudyFitTest, FindsTheLoadThatMadeAMeasurement) {
  const double load = 13e6, range = 12e6;
  const Json measured = told("sweep", {"--set", fmt::format("load={}", load)});
  const Json& values = measured["runs"][0]["quantities"];
  std::string path = "x,y\n";
  for (const Json& point : values["tip.path"][0])
    path += fmt::format("{},{}\n", point[0].get<double>(), point[1].get<double>());
  write_text(folder_.path / "path.csv", path);
  const Json json =
      told("fit", {"--vary", "load=8:20MPa", "--to", "tip.path=path.csv", "--to",
                   fmt::format("energy.broken={}J/m", values["energy.broken"].get<double>()),
                   "--to", fmt::format("crack.length={}m", values["crack.length"].get<double>())});
  const Json& found = json["parameters"]["load"];
  EXPECT_NEAR(found["value"].get<double>(), load, range / 32.0);
  EXPECT_GT(found["uncertainty"].get<double>(), 0.0);
  EXPECT_EQ(json["residuals"].size(), 3U);
}

TEST_F(StudyFitTest, FindsTheToughness) {
  const double G0 = 200.0, range = 300.0;
  const Json measured = told("sweep", {"--set", fmt::format("material.G0={}", G0)});
  const Json& values = measured["runs"][0]["quantities"];
  const Json json =
      told("fit", {"--vary", "material.G0=100:400J/m2", "--to",
                   fmt::format("energy.broken={}J/m", values["energy.broken"].get<double>()),
                   "--to", fmt::format("crack.length={}m", values["crack.length"].get<double>())});
  EXPECT_NEAR(json["parameters"]["material.G0"]["value"].get<double>(), G0, range / 32.0);
}

}  // namespace
}  // namespace hackle
