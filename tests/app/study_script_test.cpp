// SPDX-License-Identifier: MIT
// study.trade and its like, called by a script of hackle run.
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "app/program.hpp"
#include "base/files.hpp"
#include "console/reference/vocabulary.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

const std::string plate = R"(
local o = options { load = 12*MPa }
local p = plate { width = 20*mm, height = 8*mm, material = "duran50" }
p:crack { from = {0, 4*mm}, to = {8*mm, 4*mm} }
p:traction { edge = "top", stress = {0, o.load} }
p:traction { edge = "bottom", stress = {0, -o.load} }
local s = simulate(p, { spacing = 1*mm, horizon = 3*mm })
s:run(4*us)
)";

class StudyScriptTest : public testing::Test {
 protected:
  StudyScriptTest() { write_text(folder_.path / "plate.lua", plate); }
  test::Ended run(const std::string& text) {
    write_text(folder_.path / "main.lua", text);
    return program_.run({"run", "main.lua", "-q"});
  }

  test::Folder folder_;
  test::Program program_{folder_};
};

TEST_F(StudyScriptTest, EveryExampleRuns) {
  int count = 0;
  for (const FunctionDoc* doc : all_docs()) {
    if (!doc->name.starts_with("study.")) continue;
    const test::Ended ended = run(std::string(doc->example));
    EXPECT_EQ(ended.code, 0) << doc->name << ": " << ended.err;
    ++count;
  }
  EXPECT_EQ(count, 4);
}

TEST_F(StudyScriptTest, ReturnsTheNumbersAndLeavesTheFiles) {
  const test::Ended ended =
      run("local w = study.sweep { 'plate.lua', vary = { 'load=6:12:6MPa' } }\n"
          "print(w.kind, #w.runs, w.runs[2].settings.load)");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("sweep\t2\t12"));
  EXPECT_TRUE(std::filesystem::exists(folder_.path / "out/main/study/plate/sweep.csv"));
}

TEST_F(StudyScriptTest, AStudyOfItselfEnds) {
  const test::Ended ended = run("study.trade { 'main.lua' }");
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("study.trade: this run is itself one of a study"));
}

TEST_F(StudyScriptTest, TheCommandKnowsItsKinds) {
  const test::Ended ended = program_.run({"study", "trad", "plate.lua"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("there is no study 'trad' (did you mean 'trade'?)"));
  EXPECT_THAT(program_.run({"study"}).err, HasSubstr("no study is named (there are trade"));
  EXPECT_THAT(program_.run({"study", "--help"}).out, HasSubstr("ensemble"));
}

TEST_F(StudyScriptTest, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(run("study.trde { 'plate.lua' }").err, HasSubstr("(did you mean 'trade'?)"));
  EXPECT_THAT(run("study.trade { 'plate.lua', compare = { 'fork.tme' } }").err,
              HasSubstr("(did you mean 'fork.time'?)"));
  EXPECT_THAT(run("study.trade { 'plate.lua', set = { 'load' } }").err,
              HasSubstr("'load', which is not key=value"));
  EXPECT_THAT(run("study.trade { 'none.lua' }").err, HasSubstr("none.lua"));
}

}  // namespace
}  // namespace hackle
