// SPDX-License-Identifier: MIT
// A Lua 5.4 state in its C++ build: errors of Lua are C++ exceptions, so destructors run when one
// passes. They are not std::exception; catch (...) around a call of Lua would swallow them.
#pragma once

#include <cstdint>
#include <string_view>

#include <lua.hpp>

#include "base/error.hpp"
#include "console/lua/lua_memory.hpp"

namespace hackle {

class LuaState {
 public:
  // Without any library. Its values may take so many bytes. Throws Error (run_failed) when there is
  // no memory for it.
  explicit LuaState(std::size_t max_memory = default_lua_memory);
  ~LuaState();
  LuaState(const LuaState&) = delete;
  LuaState& operator=(const LuaState&) = delete;

  lua_State* get() const { return state_; }
  operator lua_State*() const { return state_; }

 private:
  LuaMemory memory_;
  lua_State* state_;
};

// What is said of a state that has asked for more than its limit.
Error out_of_memory(lua_State* L);

// See LuaMemory::hold; collects garbage where there is no room. Throws what out_of_memory says.
void hold_memory(lua_State* L, std::size_t bytes);
void release_memory(lua_State* L, std::size_t bytes);

// [-0, +1]
void push_text(lua_State* L, std::string_view text);
// [-0, +0] Into the table on top.
void set_number(lua_State* L, const char* name, double value);
void set_integer(lua_State* L, const char* name, std::int64_t value);

// Says which of two tables, functions, coroutines or full userdata was made first: it has the
// lesser number. Not of functions of C without upvalues, which are not made.
std::uint64_t birth_of(lua_State* L, int index);

class Session;

// The session that the bound functions of a state and of all its coroutines work for. Null in a
// state that has none.
void set_session(lua_State* L, Session* session);
Session* find_session(lua_State* L);
// Of a state that has one.
Session& session_of(lua_State* L);

}  // namespace hackle
