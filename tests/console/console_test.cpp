// SPDX-License-Identifier: MIT
#include "console/console.hpp"

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "base/units.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Console, KnowsTheUnits) {
  std::string script;
  for (const Unit& unit : units()) {
    script += "assert(" + std::string(unit.name) + " == " + shortest(unit.factor) + ")\n";
  }
  EXPECT_EQ(test::message_of(script), "");
}

TEST(Console, AScriptSeesItsArguments) {
  Console console(test::quiet());
  console.run_text(
      "assert(arg[0] == 'x.lua' and arg[1] == 'a' and #arg == 2)\n"
      "assert(select('#', ...) == 2 and select(2, ...) == 'b c')",
      "x.lua", {"a", "b c"});
}

TEST(Console, AFirstLineForTheShellKeepsLineNumbers) {
  EXPECT_THAT(test::message_of("#!/usr/bin/env hackle\nerror 'here'"),
              HasSubstr("test.lua:2: here"));
  EXPECT_EQ(test::message_of("#"), "");
}

TEST(Console, ModulesLieBesideTheScript) {
  const test::Folder folder;
  write_text(folder.path / "part.lua", "return 42");
  write_text(folder.path / "main.lua", "assert(require 'part' == 42)");
  Console console(test::quiet());
  EXPECT_NO_THROW(console.run_file(folder.path / "main.lua"));
}

TEST(Console, AFileKeepsItsNameInMessagesAndSummaries) {
  const test::Folder folder;
  const auto path = folder.path / "my scene.lua";
  write_text(path, test::scene);
  Console console(test::quiet());
  console.run_file(path);
  ASSERT_EQ(console.simulations().size(), 1u);
  EXPECT_EQ(console.simulations()[0].script, path.string());
}

TEST(Console, EvaluatesExpressionsAndStatements) {
  Console console(test::quiet());
  EXPECT_THAT(console.evaluate("1 + 1, 'x'"), ElementsAre("2", "x"));
  EXPECT_THAT(console.evaluate("= 7"), ElementsAre("7"));
  EXPECT_THAT(console.evaluate("a = 3"), ElementsAre());
  EXPECT_THAT(console.evaluate("a"), ElementsAre("3"));
  EXPECT_THAT(console.evaluate("nil"), ElementsAre("nil"));
}

TEST(Console, AnErrorAtThePromptHasNoPlace) {
  Console console(test::quiet());
  try {
    console.evaluate("plate { }");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("plate: width is missing"));
  }
}

TEST(Console, SeesWhichTextIsIncomplete) {
  const Console console(test::quiet());
  for (const char* text : {"for i = 1, 2 do", "f(", "x = {", "if a then b()", "return (", "[[a"})
    EXPECT_TRUE(console.is_incomplete(text)) << text;
  for (const char* text : {"1 +* 2", "x = 1", "f()", "", "end", "= 3", "local"})
    EXPECT_EQ(console.is_incomplete(text), std::string_view(text) == "local") << text;
}

TEST(Console, AValueWhoseTextFailsIsAnError) {
  Console console(test::quiet());
  EXPECT_THROW(console.evaluate("setmetatable({}, { __tostring = function() error 'no' end })"),
               Error);
  EXPECT_THAT(console.evaluate("1"), ElementsAre("1"));
}

TEST(Console, OsExitIsNoFailureAndClosesEverything) {
  const test::Folder folder;
  Console console(test::quiet(folder.path));
  console.run_text(
      test::scene + "s:movie { 'a.mp4', every = 1*us }\ns:run(1*us)\nos.exit(3)\nerror 'after'",
      "test.lua");
  EXPECT_EQ(console.exit_code(), 3);
  EXPECT_TRUE(std::filesystem::exists(folder.path / "a.mp4"));
}

}  // namespace
}  // namespace hackle
