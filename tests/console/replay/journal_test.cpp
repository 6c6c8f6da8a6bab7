// SPDX-License-Identifier: MIT
#include "console/replay/journal.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "console/lua/lua_state.hpp"
#include "console/replay/lua_values.hpp"

namespace hackle {
namespace {

const std::vector<TimePoint> points{{0, {}, {}, 0.0},
                                    {7, {}, {1e-6, 9}, 7e-8},
                                    {8, {}, {1e-6, 9}, 7.5e-8},
                                    {8, {3e-6, 8}, {3e-6, 8}, 3e-6},
                                    {1'000'000'000'000, {3e-6, 8}, {0.1, 1'000'000'000'001}, 0.1}};

JournalWriter written() {
  JournalWriter journal;
  for (const TimePoint& point : points) journal.point(point);
  for (const std::uint64_t number : {std::uint64_t{0}, std::uint64_t{127}, std::uint64_t{128},
                                     std::numeric_limits<std::uint64_t>::max()})
    journal.number(number);
  for (const double value : {-0.0, 1e-300, std::numeric_limits<double>::infinity()})
    journal.bits(value);
  journal.text(std::string("a\0b", 3));
  journal.failure(Error(ErrorKind::refused, {{"what", "remedy"}, {"other", ""}}));
  return journal;
}

void read_all(JournalReader& journal) {
  for (const TimePoint& point : points) {
    const TimePoint read = journal.point();
    EXPECT_EQ(read.step, point.step);
    EXPECT_EQ(read.clock, point.clock);
    EXPECT_EQ(read.aim.end_time, point.aim.end_time);
    EXPECT_EQ(read.aim.last_step, point.aim.last_step);
    EXPECT_EQ(read.time, point.time);
  }
  EXPECT_EQ(journal.number(), 0U);
  EXPECT_EQ(journal.number(), 127U);
  EXPECT_EQ(journal.number(), 128U);
  EXPECT_EQ(journal.number(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_TRUE(std::signbit(journal.bits()));
  EXPECT_EQ(journal.bits(), 1e-300);
  EXPECT_TRUE(std::isinf(journal.bits()));
  EXPECT_EQ(journal.text(), std::string("a\0b", 3));
  const Error failure = journal.failure();
  EXPECT_EQ(failure.kind(), ErrorKind::refused);
  ASSERT_EQ(failure.problems().size(), 2U);
  EXPECT_EQ(failure.problems()[0].remedy, "remedy");
  EXPECT_EQ(failure.problems()[1].what, "other");
}

TEST(Journal, IsReadAsItWasWritten) {
  JournalReader journal(written().bytes());
  read_all(journal);
  EXPECT_TRUE(journal.at_end());
}

TEST(Journal, GoesOnBehindWhatWasRead) {
  JournalReader journal(written().bytes());
  read_all(journal);
  JournalWriter further(journal);
  further.point({9, {3e-6, 8}, {0.1, 1'000'000'000'001}, 0.2});
  JournalReader again(further.bytes());
  read_all(again);
  const TimePoint last = again.point();
  EXPECT_EQ(last.clock.since, 8);
  EXPECT_EQ(last.aim.last_step, 1'000'000'000'001);
}

TEST(Journal, ThatIsCutIsAMismatch) {
  const std::string whole = written().bytes();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    JournalReader journal(whole.substr(0, length));
    EXPECT_THROW(read_all(journal), JournalMismatch) << length;
  }
}

class LuaValues : public testing::Test {
 protected:
  LuaValues() {
    luaL_requiref(L_, LUA_GNAME, luaopen_base, 1);
    lua_settop(L_, 0);
  }
  void push(const std::string& values) {
    ASSERT_EQ(luaL_dostring(L_, ("return " + values).c_str()), LUA_OK) << lua_tostring(L_, -1);
  }
  std::string texts() {
    return texts_of(L_, 1, lua_gettop(L_), [](lua_State*, int) { return std::string("object"); });
  }
  LuaState L_;
};

TEST_F(LuaValues, ComeBackWithEveryBit) {
  push(
      "nil, true, false, 3, -9007199254740993, 0.1, -0.0, 1/0, 'a\\0b', {}, {1, 2, x = {y = 'z'}, "
      "[2.5] = false}");
  const std::string before = texts();
  JournalWriter journal;
  ASSERT_TRUE(write_values(L_, 1, lua_gettop(L_), journal));
  lua_settop(L_, 0);
  JournalReader reader(journal.bytes());
  EXPECT_EQ(push_values(L_, reader), 11);
  EXPECT_EQ(texts(), before);
  EXPECT_TRUE(reader.at_end());
}

// Lua orders keys by where they lie in memory.
TEST_F(LuaValues, AreTheSameTextInAnyOrder) {
  push("{ a = 1, b = 2, c = 3, 4, 5 }");
  const std::string one = texts();
  lua_settop(L_, 0);
  push(
      "(function() local t = { c = 3, 4, 5 } for k = 1, 100 do t[k .. ''] = k end "
      "for k = 1, 100 do t[k .. ''] = nil end t.b = 2 t.a = 1 return t end)()");
  EXPECT_EQ(texts(), one);
}

TEST_F(LuaValues, DifferInOneBit) {
  push("0.1");
  const std::string one = texts();
  lua_settop(L_, 0);
  push("0.1 + 2^-56");
  EXPECT_NE(texts(), one);
}

TEST_F(LuaValues, ThatCannotBeWrittenLeaveNothing) {
  for (const char* values :
       {"print", "{ x = { print } }", "(function() local t = {} t.t = t return t end)()"}) {
    lua_settop(L_, 0);
    push(values);
    JournalWriter journal;
    EXPECT_FALSE(write_values(L_, 1, 1, journal)) << values;
    EXPECT_EQ(journal.bytes(), "") << values;
  }
}

// The file may have been made by anybody.
TEST_F(LuaValues, OfDamagedBytesAreAMismatchOrValues) {
  push("1, 'text', { 1, 2, { 3 } }, 0.5");
  JournalWriter journal;
  ASSERT_TRUE(write_values(L_, 1, lua_gettop(L_), journal));
  const std::string whole = journal.bytes();
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (int value = 0; value < 256; ++value) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(value);
      lua_settop(L_, 0);
      JournalReader reader(damaged);
      try {
        push_values(L_, reader);
      } catch (const JournalMismatch&) {
      }
    }
}

}  // namespace
}  // namespace hackle
