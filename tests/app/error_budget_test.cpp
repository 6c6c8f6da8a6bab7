// SPDX-License-Identifier: MIT
// simulate(p, { within = ... }) in a script, by trial runs of it.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

const std::string budgeted = R"(
local p = plate { width = 40*mm, height = 20*mm, material = "duran50" }
p:crack { from = {0, 10*mm}, to = {15*mm, 10*mm} }
p:traction { edge = "top", stress = {0, 24*MPa} }:traction { edge = "bottom", stress = {0, -24*MPa} }
p:nofail { edge = "top", depth = 2*mm }:nofail { edge = "bottom", depth = 2*mm }
local s = simulate(p, { within = 3*mm, horizon = 2*mm })
s:run(12*us)
print(s:report())
)";

class ErrorBudgetTest : public testing::Test {
 protected:
  ErrorBudgetTest() { write_text(folder_.path / "small.lua", budgeted); }
  test::Ended run(std::vector<std::string> words) const {
    words.insert(words.begin(), {"run", "small.lua"});
    return test::Program(folder_).run(words);
  }
  test::Folder folder_;
};

TEST_F(ErrorBudgetTest, ChoosesTheSpacingAndReportsIt) {
  const test::Ended ended = run({"--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["budget"]["within_m"], 3e-3);
  EXPECT_EQ(json["budget"]["spacing_m"], json["numerics"]["spacing_m"]);
  EXPECT_GE(json["budget"]["trials"], 3);
  EXPECT_THAT(run({"--force"}).out, HasSubstr("budget   paths within 3 mm"));
}

TEST_F(ErrorBudgetTest, TriesNothingIfTheSpacingIsSet) {
  const test::Ended ended = run({"--json", "--set", "simulate.spacing=1mm"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_FALSE(nlohmann::json::parse(ended.out).contains("budget"));
}

TEST_F(ErrorBudgetTest, RefusesABudgetThatIsNoLength) {
  const test::Ended ended = run({"--set", "simulate.within=-1mm"});
  EXPECT_NE(ended.code, 0);
  EXPECT_THAT(ended.err, HasSubstr("within"));
}

}  // namespace
}  // namespace hackle
