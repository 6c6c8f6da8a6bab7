// SPDX-License-Identifier: MIT
// hackle study envelope and features as a user calls them; ctest runs the quick sample of the
// envelope as extremes.EnvelopeQuick.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class EnvelopeTest : public testing::Test {
 protected:
  test::Ended study(std::vector<std::string> words) {
    words.insert(words.begin(), "study");
    return test::Program(folder_).run(words);
  }
  bool wrote(const std::string& name) const { return std::filesystem::exists(folder_.path / name); }

  test::Folder folder_;
};

TEST_F(EnvelopeTest, TellsHowCellsEndAndDrawsAMap) {
  const auto ended = study({"envelope", "--quick", "--family", "still,nonsense", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json told = Json::parse(ended.out);
  EXPECT_EQ(told["schema"], 1);
  EXPECT_EQ(told["kind"], "envelope");
  ASSERT_GT(told["cells"].size(), 10U);
  EXPECT_EQ(told["counts"]["failed"], 0);
  for (const Json& cell : told["cells"]) {
    const std::string due = cell["family"] == "still" ? "right" : "refused";
    EXPECT_EQ(cell["verdict"], due) << cell["name"] << ": " << cell["why"];
  }
  for (const char* file : {"envelope.png", "envelope.csv", "envelope.json"})
    EXPECT_TRUE(wrote(std::string("out/study/envelope/") + file)) << file;
  // The second time nothing is run.
  const auto again = study({"envelope", "--quick", "--family", "still,nonsense", "--json"});
  EXPECT_EQ(Json::parse(again.out), told);
}

TEST_F(EnvelopeTest, RefusesFamiliesThatAreNone) {
  const auto ended = study({"envelope", "--family", "spn"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("did you mean 'spin'?"));
}

TEST_F(EnvelopeTest, MeasuresFeaturesOneAtATime) {
  const auto ended = study({"features", "--feature", "alpha,record", "--rounds", "1", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json features = Json::parse(ended.out)["features"];
  ASSERT_EQ(features.size(), 3U);
  EXPECT_EQ(features[0]["name"], "none");
  EXPECT_TRUE(features[0]["kernel_features"].empty());
  EXPECT_EQ(features[1]["kernel_features"], Json::array({"alpha"}));
  for (const Json& one : features) EXPECT_GT(one["cpu_s"], 0.0) << one["name"];
  // HDF5 takes more memory than a million bytes.
  EXPECT_EQ(features[0]["bytes"], 0);
  EXPECT_GT(features[2]["bytes"], 1'000'000);
  // It is touched by those that record, when they do.
  EXPECT_LT(features[1]["start_bytes"], 1'500'000);
  EXPECT_LT(features[2]["start_bytes"], features[2]["bytes"]);
}

TEST_F(EnvelopeTest, MeasuresAScriptWithAndWithoutItsPictures) {
  std::ofstream(folder_.path / "small.lua")
      << "local p = plate { width = 20*mm, height = 10*mm, material = 'duran50' }\n"
         "p:traction { edge = 'top', stress = { 0, 1*MPa } }\n"
         "local s = simulate(p, { spacing = 1*mm })\n"
         "s:run(10*us)\n"
         "s:frame 'small.png'\n";
  const auto ended = study({"features", "small.lua", "--rounds", "1", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json features = Json::parse(ended.out)["features"];
  EXPECT_EQ(features[0]["name"], "bare");
  EXPECT_EQ(features[1]["name"], "as written");
  EXPECT_GT(features[1]["cpu_s"], features[0]["cpu_s"]);
  EXPECT_GT(features[1]["bytes"], 1'000'000);
}

}  // namespace
}  // namespace hackle
