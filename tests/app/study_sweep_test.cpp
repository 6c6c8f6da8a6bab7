// SPDX-License-Identifier: MIT
// hackle study sweep, as a user meets it.
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/study_plate.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

using StudySweepTest = test::StudiedPlate;

TEST_F(StudySweepTest, MakesTablesChartsASheetAndAFilm) {
  const test::Ended ended =
      study("sweep", {"--set", "load=6:12:3MPa", "--for", "first_bond.time,branches", "--sheet",
                      "--film", "film.mp4"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("load   first_bond.time  branches"));
  EXPECT_THAT(ended.out, HasSubstr("\n9MPa"));
  for (const char* name : {"sweep.json", "sweep.csv", "sweep-first_bond.time.png", "sheet.png"})
    EXPECT_TRUE(exists(name)) << name;
  EXPECT_TRUE(test::is_whole_mp4(folder_.path / "film.mp4"));
  const test::Ended info = program_.run({"info", "film.mp4"});
  EXPECT_EQ(info.code, 0) << info.err;
  const Json again = told("sweep", {"--set", "load=6:12:3MPa", "--sheet"});
  EXPECT_EQ(again["runs_made"], 0);
}

TEST_F(StudySweepTest, FindsAThreshold) {
  const Json json = told("sweep", {"--set", "load=6:14MPa", "--threshold", "first_bond.time < 8us",
                                   "--tolerance", "1MPa"});
  const Json& found = json["threshold"];
  EXPECT_NEAR(found["holds_at"].get<double>() - found["fails_at"].get<double>(), 1e6, 1.0);
  for (const Json& run : json["runs"]) {
    const Json& time = run["quantities"]["first_bond.time"];
    const std::string load = run["settings"]["load"];
    const bool holds = !time.is_null() && time.get<double>() < 8e-6;
    EXPECT_EQ(holds, std::stod(load) * 1e6 > found["fails_at"].get<double>()) << load;
  }
}

TEST_F(StudySweepTest, RefusesAtOnceWhatCannotBe) {
  const test::Ended unknown = study("sweep", {"--set", "lod=1:9:1MPa"});
  EXPECT_NE(unknown.code, 0);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'load'"));
  EXPECT_EQ(unknown.err.find("error:"), unknown.err.rfind("error:"));
  EXPECT_EQ(study("sweep", {"--set", "load=1:2", "--threshold", "branhces > 1"}).code, 2);
  EXPECT_EQ(study("sweep", {"--set", "load=1:2:3furlongs"}).code, 2);
  EXPECT_EQ(study("fit", {}).code, 2);
  EXPECT_EQ(study("convergence", {"--by", "size"}).code, 2);
  write_text(folder_.path / "a.lua", "print(1)");
  EXPECT_THAT(study("sweep", {}).err, HasSubstr("makes no simulation"));
}

}  // namespace
}  // namespace hackle
