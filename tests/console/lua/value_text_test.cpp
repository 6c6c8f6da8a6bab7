// SPDX-License-Identifier: MIT
#include "console/lua/value_text.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

// Returns the text of an expression's value, as the prompt shows it.
std::string shown(const std::string& expression, const std::string& before = "x = 1") {
  Console console(test::quiet());
  console.evaluate(before);
  return console.evaluate(expression).at(0);
}

TEST(ValueText, PlainValuesAreAsLuaHasThem) {
  EXPECT_EQ(shown("'a \"b\"'"), "a \"b\"");
  EXPECT_EQ(shown("2.5"), "2.5");
  EXPECT_EQ(shown("1e300 * 1e10"), "inf");
  EXPECT_EQ(shown("nil"), "nil");
  EXPECT_EQ(shown("true"), "true");
  EXPECT_THAT(shown("print"), testing::StartsWith("function: "));
}

TEST(ValueText, TablesShowWhatTheyHold) {
  EXPECT_EQ(shown("{}"), "{}");
  EXPECT_EQ(shown("{1, 'two', {3}}"), "{1, \"two\", {3}}");
  EXPECT_EQ(shown("{b = 2, a = 1, 7}"), "{7, a = 1, b = 2}");
  EXPECT_EQ(shown("{['a b'] = 1, [2.5] = 2, [true] = 3}"),
            "{[\"a b\"] = 1, [2.5] = 2, [true] = 3}");
  EXPECT_EQ(shown("{'a\\n\\0\\\\'}"), "{\"a\\n\\0\\\\\"}");
  EXPECT_EQ(shown("{nil, 2}"), "{nil, 2}");
}

TEST(ValueText, DeepTablesAndCyclesEnd) {
  EXPECT_EQ(shown("{{{{{}}}}}"), "{{{{...}}}}");
  EXPECT_EQ(shown("t", "t = {} t.t = t"), "{t = {t = {t = {...}}}}");
}

TEST(ValueText, LongTablesEnd) {
  const std::string text = shown("t", "t = {} for k = 1, 100 do t[k] = k end");
  EXPECT_THAT(text, testing::EndsWith(", 39, 40, ... 60 more}"));
  EXPECT_THAT(shown("t", "t = {} for k = 1, 1e5 do t['k' .. k] = k end"),
              testing::EndsWith("... 99960 more}"));
}

TEST(ValueText, WhatHasATextOfItsOwnShowsIt) {
  EXPECT_EQ(shown("{p}", "p = setmetatable({1}, { __tostring = function() return 'mine' end })"),
            "{mine}");
  EXPECT_THAT(shown("{ plate { width = 10*mm, height = 4*mm, material = 'duran50' } }"),
              testing::StartsWith("{plate 10 x 4 mm, Duran 50"));
  EXPECT_THROW(shown("{p}", "p = setmetatable({}, { __tostring = error })"), Error);
}

}  // namespace
}  // namespace hackle
