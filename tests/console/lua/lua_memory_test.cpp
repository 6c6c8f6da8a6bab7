// SPDX-License-Identifier: MIT
// Lua may run out of memory at any of its allocations, inside any bound function: the exception
// must pass through C++ frames only and come out as an error.
#include "console/lua/lua_memory.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "console/reference/vocabulary.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

std::string message_with(std::size_t memory, const std::string& script,
                         const test::Folder& folder) {
  ConsoleSettings settings = test::quiet(folder.path);
  settings.lua_memory = memory;
  try {
    return test::message_of(script, settings);
  } catch (const Error& error) {  // from the console itself, before it runs a script
    return error.what();
  }
}

TEST(LuaMemory, ALimitOfNothingIsAnError) {
  const test::Folder folder;
  EXPECT_EQ(message_with(0, "", folder), "no memory for a Lua state");
}

// Bisects the limit to the last failing allocation, so that each function fails at places from its
// first allocation to its last.
TEST(LuaMemory, EveryFunctionCanBeStoppedAnywhere) {
  const test::Folder folder;
  EXPECT_EQ(message_with(default_lua_memory, test::scene + test::recorded, folder), "");
  for (const FunctionDoc* doc : all_docs()) {
    if (doc->name.starts_with("study.")) continue;  // their work is done by other programs
    const bool looks_back = doc->owner == "r" || doc->name == "side_by_side";
    // Movies need more checks than a coarse plate has steps; a fine plate reaches equilibrium
    // slowly.
    const std::string spacing = doc->name == "relax" ? "2*mm" : "0.5*mm";
    const std::string script = test::scene + (looks_back ? test::reopened : "") +
                               "s = simulate(p, { spacing = " + spacing + " })\n" +
                               std::string(doc->example);
    std::size_t min = 0, enough = std::size_t{1} << 20U;
    while (enough - min > 64) {
      const std::size_t limit = min + (enough - min) / 2;
      const std::string message = message_with(limit, script, folder);
      (message.empty() ? enough : min) = limit;
      EXPECT_TRUE(message.empty() || message.find("memory") != std::string::npos)
          << doc->name << " with " << limit << " bytes: " << message;
    }
    EXPECT_LT(enough, std::size_t{1} << 20U) << doc->name;
  }
}

TEST(LuaMemory, WhatIsHeldOutsideOfLuaCounts) {
  LuaMemory memory(1000);
  EXPECT_TRUE(memory.hold(600));
  EXPECT_FALSE(memory.hold(401));
  EXPECT_FALSE(memory.hold(std::numeric_limits<std::size_t>::max()));
  EXPECT_EQ(LuaMemory::allocate(&memory, nullptr, 0, 401), nullptr);
  memory.release(600);
  EXPECT_TRUE(memory.hold(1000));
}

TEST(LuaMemory, HasNoLimitWhenAStateIsClosed) {
  LuaMemory memory(1000);
  EXPECT_TRUE(memory.hold(1000));
  void* block = LuaMemory::allocate(&memory, nullptr, 0, 1);
  EXPECT_EQ(block, nullptr);
  memory.lift_limit();
  block = LuaMemory::allocate(&memory, nullptr, 0, 1);
  EXPECT_NE(block, nullptr);
  LuaMemory::allocate(&memory, block, 1, 0);
  EXPECT_EQ(memory.used(), 1000U);
}

// A hundred thousand cracks take some 8 MB, all of it outside of Lua.
constexpr const char* cracked =
    "local function cracked(seed)\n"
    "  return plate { width = 1, height = 1, material = 'duran50' }:random_cracks {\n"
    "    count = 100000, length = { 1*mm, 2*mm }, seed = seed }\n"
    "end\n";

TEST(LuaMemory, PartsOfPlatesCount) {
  ConsoleSettings settings = test::quiet();
  settings.lua_memory = std::size_t{64} << 20U;
  EXPECT_THAT(
      test::message_of(
          std::string(cracked) + "local t = {} for k = 1, 100 do t[k] = cracked(k) end", settings),
      testing::HasSubstr("not enough memory"));
  EXPECT_EQ(test::message_of(std::string(cracked) + "for k = 1, 20 do cracked(k) end", settings),
            "");
}

TEST(LuaMemory, IsLimited) {
  ConsoleSettings settings = test::quiet();
  settings.lua_memory = std::size_t{8} << 20U;
  const std::string told =
      "not enough memory: the script's Lua values exceed 8 MB (--lua-memory allows more)";
  for (const char* greedy :
       {"local t = {} for i = 1, 1e9 do t[i] = i end", "return ('x'):rep(1e9)",
        "local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(1000) .. i end",
        "coroutine.wrap(function() return ('x'):rep(1e9) end)()",
        "local s = 'x' while true do s = s .. s end", "error(('x'):rep(5e6) .. ('y'):rep(4e6))",
        "return io.stdin:read(1e9)",
        "local t = {} for i = 1, 1e9 do t[i] = coroutine.create(print) end",
        "local t = {} for i = 1, 1e9 do t[i] = plate{width=1,height=1,material='duran50'} end"})
    EXPECT_THAT(test::message_of(greedy, settings), testing::HasSubstr(told)) << greedy;
}

TEST(LuaMemory, IsGivenBack) {
  ConsoleSettings settings = test::quiet();
  settings.lua_memory = std::size_t{8} << 20U;
  EXPECT_EQ(test::message_of("for i = 1, 1000 do local s = ('x'):rep(1e6) .. i end\n"
                             "assert(not pcall(string.rep, 'x', 1e8))\n"
                             "assert(#('x'):rep(2e6) == 2e6)",
                             settings),
            "");
}

}  // namespace
}  // namespace hackle
