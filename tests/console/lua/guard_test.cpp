// SPDX-License-Identifier: MIT
#include "console/lua/guard.hpp"

#include <memory>

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

constexpr const char* bad_plate = "plate { width = -1, height = 1, material = 'duran50' }";

TEST(Guard, AnErrorHasThePlaceOfTheCallBeforeEachProblem) {
  EXPECT_EQ(test::message_of("\nplate { width = -1, height = 0, material = 'duran50' }"),
            "test.lua:2: plate: width is -1 m, it must be above 0 m\n"
            "test.lua:2: plate: height is 0 m, it must be above 0 m");
}

TEST(Guard, TheKindSurvivesPcallAndError) {
  const auto failure =
      test::failure_of(std::string("local ok, e = pcall(function() ") + bad_plate + " end)\n" +
                           "assert(not ok and e.kind == 'refused', e.kind)\nerror(e)",
                       test::quiet());
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind(), ErrorKind::refused);
}

TEST(Guard, TheKindSurvivesACoroutine) {
  const auto failure = test::failure_of(
      std::string("coroutine.wrap(function() ") + bad_plate + " end)()", test::quiet());
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind(), ErrorKind::refused);
}

TEST(Guard, AnErrorReadsAsText) {
  EXPECT_EQ(
      test::message_of(std::string("local ok, e = pcall(function() ") + bad_plate + " end)\n" +
                       "assert(tostring(e) == e.message)\n"
                       "assert(('x ' .. e):find('x test.lua:1: plate: width', 1, true))\n"
                       "assert((e .. '!'):sub(-1) == '!')"),
      "");
}

TEST(Guard, ErrorsOfLuaPassThrough) {
  const auto failure = test::failure_of("local t = nil; t.x = 1", test::quiet());
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind(), ErrorKind::script);
  EXPECT_THAT(failure->what(), testing::HasSubstr("test.lua:1: attempt to index a nil value"));
}

TEST(Guard, AnyValueCanBeAnError) {
  EXPECT_EQ(test::message_of("error({})"), "(error object is a table value)");
  EXPECT_EQ(test::message_of("error()"), "(error object is a nil value)");
  EXPECT_EQ(test::message_of("error(setmetatable({}, {__tostring = function() return 'me' end}))"),
            "me");
  EXPECT_NE(test::message_of("error(setmetatable({}, {__tostring = function() error(1) end}))"),
            "");
}

// Reports its destruction through a pointer.
struct Witness {
  explicit Witness(bool& gone_) : gone(gone_) {}
  ~Witness() { gone = true; }
  bool& gone;
};
bool witness_is_gone = false;

int raise_in_lua(lua_State* L) {
  const Witness witness(witness_is_gone);
  return luaL_error(L, "of Lua");
}

int throw_foreign(lua_State*) {
  throw std::out_of_range("foreign");
}

TEST(Guard, DestructorsRunWhenAnErrorOfLuaPasses) {
  const LuaState L;
  open_errors(L);
  witness_is_gone = false;
  lua_pushcfunction(L, guarded<raise_in_lua>);
  EXPECT_THROW(protected_call(L, 0, 0), Error);
  EXPECT_TRUE(witness_is_gone);
  EXPECT_EQ(lua_gettop(L), 0);
}

TEST(Guard, ForeignExceptionsBecomeFailedRuns) {
  const LuaState L;
  open_errors(L);
  lua_pushcfunction(L, guarded<throw_foreign>);
  try {
    protected_call(L, 0, 0);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::run_failed);
    EXPECT_STREQ(error.what(), "foreign");
  }
}

}  // namespace
}  // namespace hackle
