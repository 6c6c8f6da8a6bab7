// SPDX-License-Identifier: MIT
#include "console/lua/key_order.hpp"

#include <gmock/gmock.h>

#include "base/interrupt.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

void expect_true(const std::string& script) {
  EXPECT_EQ(test::message_of(script), "") << script;
}

// Expects the values of a table to be 1, 2, 3, ... in the order of pairs, and of next.
const std::string in_order = R"(
local function check(t)
  local n = 0
  for key, value in pairs(t) do n = n + 1 assert(value == n, tostring(key) .. " is " .. n) end
  local m = 0
  for key, value in next, t do m = m + 1 assert(value == m, tostring(key) .. " is " .. m) end
  assert(n == m)
  return n
end
)";

TEST(KeyOrder, IsThatOfIndicesNumbersTextsAndTheRest) {
  expect_true(in_order + R"(
    local made = { {}, function() return in_order end, coroutine.create(print), {}, io.stdout }
    made[5] = nil
    local t = { [true] = 15, [false] = 14, b = 12, a = 10, ["a\0"] = 11, [""] = 9, ["\xff"] = 13,
      [-1.5] = 6, [-math.huge] = 4, [0] = 7, [7] = 3, [math.huge] = 8, 1, 2,
      [math.mininteger] = 5 }
    for k = #made, 1, -1 do t[made[k]] = 15 + k end
    assert(check(t) == 19))");
}

TEST(KeyOrder, TellsIntegersFromFloatsBesideThem) {
  expect_true(in_order + R"(
    local big = 2^53 | 0
    check { [big - 1] = 1, [big] = 2, [big + 1] = 3, [0x1p63] = 5, [math.maxinteger] = 4,
      [0x1p64] = 6 }
    check { [2.5] = 3, [3] = 2, [2] = 1 }
    check { [-2.5] = 1, [-2] = 2, [-0.5] = 3, [0] = 4, [0.5] = 5 })");
}

TEST(KeyOrder, OfObjectsIsThatInWhichTheyWereMade) {
  expect_true(in_order + R"(
    local things = {}
    for k = 1, 40 do
      things[k] = k % 4 == 0 and {} or k % 4 == 1 and function() return k end
        or k % 4 == 2 and coroutine.create(function() end)
        or plate { width = 10*mm, height = 10*mm, material = "duran50" }
      local garbage = {} garbage = nil
      if k % 7 == 0 then collectgarbage() end
    end
    local t = {}
    for k = 40, 1, -1 do t[things[k]] = k end
    assert(check(t) == 40))");
}

TEST(KeyOrder, EntriesMayChangeAndVanishOnTheWay) {
  expect_true(R"(
    for _, way in ipairs { pairs, function(t) return next, t end } do
      local t, seen = { 1, 2, 3, a = 4, b = 5, c = 6 }, {}
      for key in way(t) do
        seen[#seen + 1] = tostring(key)
        t[key] = nil
        if key == 2 then t[3] = nil end
        if key == "a" then t.b = nil t.c = 7 end
      end
      assert(table.concat(seen, " ") == "1 2 a c", table.concat(seen, " "))
      assert(next(t) == nil)
      t, seen = { 1, 2, [0] = 0 }, {}
      for key in way(t) do seen[#seen + 1] = key t[key] = nil end
      assert(table.concat(seen, " ") == "1 2 0")
    end)");
}

TEST(KeyOrder, WalksMayBeNestedAndBrokenOff) {
  expect_true(R"(
    local t, count = { a = 1, b = 2, c = 3 }, 0
    for _ in pairs(t) do for _ in pairs(t) do count = count + 1 end end
    for _ in next, t do for _ in next, t do count = count + 1 end end
    for key in next, t do if key == "a" then break end end
    for key in next, t do count = count + 1 end
    assert(count == 21, count)
    t.aa = 9
    assert(next(t, "a") == "aa" and next(t, "c") == nil and next({}) == nil))");
}

TEST(KeyOrder, ANewWalkMeetsWhatWasAdded) {
  expect_true(R"(
    local t = { b = 1, c = 2 }
    assert(next(t) == "b" and next(t, "b") == "c")
    t.a = 0
    assert(next(t) == "a" and next(t, "a") == "b"))");
}

TEST(KeyOrder, PairsAsksTheMetatable) {
  expect_true(R"(
    local t = setmetatable({}, { __pairs = function(self) return function(_, k)
      if not k then return 1, self end end, self, nil end })
    for k, v in pairs(t) do assert(k == 1 and v == t) end
    local waits = setmetatable({}, { __pairs = function() coroutine.yield(7) return next, {} end })
    local co = coroutine.wrap(function() for _ in pairs(waits) do end return 8 end)
    assert(co() == 7 and co() == 8))");
}

TEST(KeyOrder, RefusesWhatIsNoTable) {
  EXPECT_THAT(test::message_of("pairs(nil)"), HasSubstr("table expected, got nil"));
  EXPECT_THAT(test::message_of("pairs()"), HasSubstr("bad argument #1 to 'pairs'"));
  EXPECT_THAT(test::message_of("next(1)"), HasSubstr("table expected"));
}

TEST(KeyOrder, LeavesAWholeLoopAsFastAsItsTableIsLong) {
  expect_true(R"(
    local t, sum = {}, 0
    for k = 1, 30000 do t[k] = k t["k" .. k] = k end
    for _, v in pairs(t) do sum = sum + v end
    for _, v in next, t do sum = sum + v end
    assert(sum == 4 * 30000 * 30001 // 2))");
}

TEST(TableSort, KeepsEqualElementsInTheirOrder) {
  expect_true(R"(
    local t = {}
    for k = 1, 3000 do t[k] = { k * 7919 % 13, k } end
    table.sort(t, function(a, b) return a[1] < b[1] end)
    for k = 2, #t do
      assert(t[k - 1][1] < t[k][1] or t[k - 1][1] == t[k][1] and t[k - 1][2] < t[k][2])
    end
    local words = { "b", "a", "C", "" }
    table.sort(words) assert(table.concat(words, ",") == ",C,a,b")
    local few = { 3, 1, 2 } table.sort(few, function(a, b) return a > b end)
    assert(few[1] == 3 and few[2] == 2 and few[3] == 1)
    table.sort({}) table.sort({ 1 }))");
}

TEST(TableSort, AsksTheMetatable) {
  expect_true(R"(
    local held = { 3, 1, 2 }
    local t = setmetatable({}, { __index = held, __newindex = held, __len = function() return 3 end })
    table.sort(t)
    assert(held[1] == 1 and held[2] == 2 and held[3] == 3))");
}

TEST(TableSort, RefusesWhatCannotBeCompared) {
  EXPECT_THAT(test::message_of("table.sort { 1, 'a' }"), HasSubstr("attempt to compare"));
  EXPECT_THAT(test::message_of("table.sort(1)"), HasSubstr("table expected"));
  EXPECT_THAT(test::message_of("table.sort({ 2, 1 }, 3)"), HasSubstr("function expected"));
  EXPECT_THAT(test::message_of("table.sort({ 2, 1 }, function() error 'no' end)"), HasSubstr("no"));
}

TEST(ObjectName, IsANumberAndNoAddress) {
  expect_true(R"(
    local a, b = {}, {}
    assert(tostring(a) == "table: 1" and tostring(b) == "table: 2" and tostring(a) == "table: 1")
    assert(tostring(print) == "function: 3")
    assert(("%s|%5.1f|%%|%s|%p"):format(b, 2, a, a) == "table: 2|  2.0|%|table: 1|table: 1")
    assert(("%-10s|"):format(a) == "table: 1  |")
    assert(tostring(setmetatable({}, { __tostring = function() return "mine" end })) == "mine")
    assert(tostring(setmetatable({}, { __name = "Kind" })) == "Kind: 4")
    assert(tostring(io.stdout):match "^file %(%d+%)$")
    assert(tostring(1) == "1" and tostring(nil) == "nil" and tostring("x") == "x"))");
  EXPECT_THAT(test::message_of("('%d'):format {}"),
              HasSubstr("test.lua:1: bad argument #2 to 'format' (number expected"));
  EXPECT_THAT(test::message_of("('%s'):format()"), HasSubstr("bad argument #2 to 'format'"));
  EXPECT_THAT(test::message_of("tostring()"), HasSubstr("value expected"));
}

TEST(Random, BeginsWithTheSameNumberAfterASeedOfNothing) {
  expect_true(R"(
    local first = math.random()
    math.randomseed(7) local seven = math.random()
    math.randomseed() assert(math.random() == first)
    math.randomseed(7) assert(math.random() == seven))");
}

}  // namespace
}  // namespace hackle
