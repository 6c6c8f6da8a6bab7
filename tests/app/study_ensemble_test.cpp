// SPDX-License-Identifier: MIT
// hackle study ensemble on a small plate.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

const std::string small_plate = R"(
local p = plate { width = 40*mm, height = 20*mm, material = "duran50" }
p:crack { from = {0, 10*mm}, to = {15*mm, 10*mm} }
p:traction { edge = "top", stress = {0, 24*MPa} }:traction { edge = "bottom", stress = {0, -24*MPa} }
p:nofail { edge = "top", depth = 2*mm }:nofail { edge = "bottom", depth = 2*mm }
local s = simulate(p, { spacing = 0.5*mm, horizon = 2*mm })
s:run(12*us)
)";

class StudyEnsembleTest : public testing::Test {
 protected:
  StudyEnsembleTest() { write_text(folder_.path / "small.lua", small_plate); }
  test::Ended study(std::vector<std::string> words) const {
    words.insert(words.begin(), {"study", "ensemble"});
    return test::Program(folder_).run(words);
  }
  test::Folder folder_;
};

TEST_F(StudyEnsembleTest, RunsAndTellsPeopleAndPrograms) {
  const test::Ended text = study({"small.lua", "--runs", "3"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("crack.length"));
  for (const char* file : {"ensemble.csv", "ensemble.json", "ensemble.png", "ensemble_cracked.png"})
    EXPECT_TRUE(std::filesystem::is_regular_file(folder_.path / "out/study/small" / file)) << file;
  const test::Ended again = study({"small.lua", "--runs", "3", "--json"});
  const auto json = nlohmann::json::parse(again.out);
  EXPECT_EQ(json["runs"], 3);
  EXPECT_EQ(json["quantities"]["first_bond.time"]["found"], 3);
}

TEST_F(StudyEnsembleTest, ScattersTheStrengthWithSeeds) {
  const test::Ended ended = study({"small.lua", "--runs", "3", "--scatter", "5%", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["change"], "strength");
  EXPECT_GT(json["quantities"]["first_bond.time"]["sd"].get<double>() +
                json["quantities"]["crack.length"]["sd"].get<double>(),
            0.0);
}

TEST_F(StudyEnsembleTest, RefusesWhatItCannotDo) {
  EXPECT_EQ(study({"none.lua"}).code, 5);
  EXPECT_EQ(study({"small.lua", "--scatter", "80%"}).code, 2);
  EXPECT_EQ(study({"small.lua", "--within", "2"}).code, 2);
  const test::Ended place = study({"small.lua", "--for", "fork.place"});
  EXPECT_EQ(place.code, 2);
  EXPECT_THAT(place.err, HasSubstr("it is no number"));
  EXPECT_THAT(study({"small.lua", "--scatter", "own"}).err, HasSubstr("no scatter of its own"));
}

}  // namespace
}  // namespace hackle
