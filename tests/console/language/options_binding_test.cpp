// SPDX-License-Identifier: MIT
#include "console/language/options_binding.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

std::string run(const std::map<std::string, std::string>& overrides, const std::string& script) {
  ConsoleSettings settings = test::quiet();
  settings.overrides = overrides;
  return test::message_of(script, settings);
}

const std::string declare = "local o = options { load = 12*MPa, film = true, name = 'a', n = 3 }\n";

TEST(Options, AreTheirDefaultsWithoutOverrides) {
  EXPECT_EQ(run({}, declare + "assert(o.load == 12e6 and o.film == true and o.name == 'a')"), "");
}

TEST(Options, NumbersAreExpressionsWithUnits) {
  EXPECT_EQ(run({{"load", "2*(10 + 2)*MPa"}}, declare + "assert(o.load == 24e6)"), "");
  EXPECT_EQ(run({{"load", "math.pi"}}, declare + "assert(o.load == math.pi)"), "");
}

TEST(Options, UnitsNeedNoStar) {
  EXPECT_EQ(run({{"load", "24MPa"}}, declare + "assert(o.load == 24e6)"), "");
  EXPECT_EQ(run({{"load", "24e6"}}, declare + "assert(o.load == 24e6)"), "");
}

TEST(Options, ADimensionIsThatOfTheDefault) {
  EXPECT_THAT(
      run({{"load", "24mm"}}, declare),
      HasSubstr("--set load=24mm: its dimension is length, that of the default 12*MPa is stress"));
  EXPECT_EQ(run({{"n", "4mm"}}, declare + "assert(o.n == 4e-3)"), "");
}

TEST(Options, WholeNumbersStayWhole) {
  EXPECT_EQ(run({{"n", "5"}}, declare + "assert(math.type(o.n) == 'integer' and o.n == 5)"), "");
  EXPECT_EQ(run({{"n", "2.5"}}, declare + "assert(o.n == 2.5)"), "");
}

TEST(Options, TextsAndFlagsFollowTheirDefaults) {
  EXPECT_EQ(run({{"name", "1+1"}, {"film", "false"}},
                declare + "assert(o.name == '1+1' and o.film == false)"),
            "");
}

TEST(Options, WhatCannotBeReadIsRefusedTogether) {
  const std::string text = run({{"load", "oops"}, {"film", "no"}, {"n", "1/0"}}, declare);
  EXPECT_THAT(text, HasSubstr("--set load=oops: not a finite number"));
  EXPECT_THAT(text, HasSubstr("--set film=no: not true or false"));
  EXPECT_THAT(text, HasSubstr("--set n=1/0: not a finite number"));
}

TEST(Options, AnOverrideCannotReachTheProgram) {
  EXPECT_THAT(run({{"load", "os.time()"}}, declare), HasSubstr("not a finite number"));
  EXPECT_THAT(run({{"load", "1 evil = 2"}}, declare), HasSubstr("not a finite number"));
}

TEST(Options, AnUnknownKeyGetsTheNearest) {
  EXPECT_THAT(run({{"lod", "1"}}, declare),
              HasSubstr("the script has no option 'lod' (did you mean 'load'?)"));
}

TEST(Options, AScriptWithoutOptionsRefusesOverridesBeforeItSimulates) {
  EXPECT_THAT(run({{"load", "1"}}, test::scene), HasSubstr("test.lua:6: --set load=1"));
  EXPECT_THAT(run({{"load", "1"}}, "local x = 1"), HasSubstr("the script has no options to set"));
}

TEST(Options, DefaultsMustBePlainValues) {
  EXPECT_THAT(run({}, "options { a = {}, b = print, 5 }"),
              testing::AllOf(HasSubstr("a is a table"), HasSubstr("b is a function"),
                             HasSubstr("5 stands in the braces without a name")));
  EXPECT_THAT(run({}, "options(3)"), HasSubstr("expected defaults in braces, got 3"));
}

}  // namespace
}  // namespace hackle
