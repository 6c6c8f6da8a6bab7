// SPDX-License-Identifier: MIT
#include "console/language/expect_binding.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

std::vector<Expectation> expectations(const std::string& script) {
  Console console(test::quiet());
  console.run_text(script, "some/where/plate.lua");
  return console.expectations();
}

Expectation only(const std::string& options) {
  const auto all = expectations(fmt::format("expect {{ 'height', source = 'book', {} }}", options));
  EXPECT_EQ(all.size(), 1U);
  return all.at(0);
}

TEST(Expect, KeepsEveryOption) {
  const Expectation e =
      only("unit = 'm', got = 2.5, value = 2, relative = 0.25, confirmed = false, reason = 'why'");
  EXPECT_EQ(e.name, "plate");
  EXPECT_EQ(e.quantity, "height");
  EXPECT_EQ(e.unit, "m");
  EXPECT_EQ(e.source, "book");
  EXPECT_EQ(e.reason, "why");
  EXPECT_FALSE(e.confirmed);
  EXPECT_EQ(e.got, 2.5);
  EXPECT_EQ(e.expected, 2.0);
  EXPECT_EQ(e.tolerance, 0.5);
  EXPECT_EQ(e.verdict(), Verdict::pass);
  const Expectation bounds = only("got = 2, min = 1, max = 3");
  EXPECT_EQ(bounds.min, 1.0);
  EXPECT_EQ(bounds.max, 3.0);
  EXPECT_FALSE(bounds.expected);
}

TEST(Expect, WhatWasNotFoundFails) {
  for (const char* got : {"nil", "0/0", "1/0", "function() end", "function() error('no') end"}) {
    const Expectation e = only(fmt::format("value = 1, got = {}", got));
    EXPECT_EQ(e.verdict(), Verdict::fail) << got;
    EXPECT_FALSE(e.got) << got;
  }
  EXPECT_THAT(only("value = 1, got = function() error('no') end").reason, HasSubstr("no"));
}

TEST(Expect, AFunctionIsCalledAtTheEnd) {
  const auto all = expectations(
      "local n = 1 expect { 'a', source = 'b', value = function() return n end, "
      "got = function() return n + 1 end } n = 5");
  EXPECT_EQ(all.at(0).expected, 5.0);
  EXPECT_EQ(all.at(0).got, 6.0);
}

TEST(Expect, AtThePromptAFunctionIsCalledAtOnce) {
  Console console(test::quiet());
  EXPECT_EQ(
      console.evaluate("expect { 'a', source = 'b', value = 1, got = function() return 1 end }"),
      std::vector<std::string>{"pass"});
  EXPECT_EQ(console.evaluate("expect { 'a', source = 'b', min = 2, got = 1 }"),
            std::vector<std::string>{"fail"});
}

// The second point is off by 0.3 of 2, by three tolerances; the third by 0.4 of 8, by one.
TEST(Expect, ACurveIsAsGoodAsItsWorstPoint) {
  const Expectation e = only(
      "at = {1, 2, 4}, along = 'x', relative = 0.05, got = {1, 2.3, 8.4}, value = function(x) "
      "return x == 2 and 2 or x*x/2 + (x == 1 and 0.5 or 0) end");
  EXPECT_EQ(e.expected, 2.0);
  EXPECT_EQ(e.got, 2.3);
  EXPECT_NEAR(e.tolerance, 0.1, 1e-15);
  EXPECT_EQ(e.verdict(), Verdict::fail);
  EXPECT_EQ(e.curve.x, (std::vector<double>{1, 2, 4}));
  EXPECT_EQ(e.curve.expected, (std::vector<double>{1, 2, 8}));
  EXPECT_EQ(e.curve.got, (std::vector<double>{1, 2.3, 8.4}));
  EXPECT_EQ(e.curve.along, "x");
  EXPECT_EQ(only("at = {1, 2}, value = 1, tolerance = 0.1, got = {1.1, 0.95}").verdict(),
            Verdict::pass);
  EXPECT_EQ(only("at = {1, 2}, value = 1, tolerance = 0.1, got = {1, 0/0}").verdict(),
            Verdict::fail);
}

TEST(Expect, RefusesWhatIsNotClear) {
  const auto message = [](const std::string& options) {
    return test::message_of("expect { 'a', source = 'b', " + options + " }");
  };
  EXPECT_THAT(message("got = 1"), HasSubstr("it is not clear what passes"));
  EXPECT_THAT(message("value = 1, max = 2"), HasSubstr("value and bounds are both given"));
  EXPECT_THAT(message("min = 3, max = 2"), HasSubstr("min lies above max"));
  EXPECT_THAT(message("value = 1, tolerance = 1, relative = 1"), HasSubstr("one is enough"));
  EXPECT_THAT(message("unsupported = true"), HasSubstr("reason is missing"));
  EXPECT_THAT(message("value = {1, 2}"), HasSubstr("at is missing"));
  EXPECT_THAT(message("at = {1, 2}, value = {1, 2, 3}"),
              HasSubstr("value has 3 numbers, at has 2"));
  EXPECT_THAT(message("at = {1, 2}, min = 1"), HasSubstr("a curve needs value"));
  EXPECT_THAT(test::message_of("expect { 'a', value = 1 }"), HasSubstr("source is missing"));
  EXPECT_EQ(message("unsupported = true, reason = 'c'"), "");
}

TEST(Expect, SaysNothingOfAScriptThatIsOnlyChecked) {
  ConsoleSettings settings = test::quiet();
  settings.purpose = Purpose::check;
  Console console(settings);
  console.run_text("expect { 'a', source = 'b', value = 1, got = function() return 1 end }",
                   "a.lua");
  EXPECT_TRUE(console.expectations().empty());
}

TEST(OnlyVerdicts, MakeNoMovieAndPrintNothing) {
  const test::Folder folder;
  ConsoleSettings settings = test::quiet(folder.path);
  settings.only_verdicts = true;
  Console console(settings);
  testing::internal::CaptureStdout();
  console.run_text(
      test::scene +
          "s:movie { 'a.mp4', every = 1*us } print 'hello' s:run(1*us) s:frame { 'a.png' }",
      "a.lua");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_FALSE(std::filesystem::exists(folder.path / "a.mp4"));
  EXPECT_TRUE(std::filesystem::exists(folder.path / "a.png"));
}

}  // namespace
}  // namespace hackle
