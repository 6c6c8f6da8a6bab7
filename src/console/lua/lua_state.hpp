// SPDX-License-Identifier: MIT
// A Lua 5.4 state in its C++ build: Lua errors are C++ exceptions, so destructors run when one
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
  // Opens no library. The values may take `max_memory` bytes. Throws Error (run_failed) if there is
  // no memory for the state.
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

// Returns the error for a state that has exceeded its memory limit.
Error out_of_memory(lua_State* L);

// See LuaMemory::hold; collects garbage if there is no room. Throws out_of_memory().
void hold_memory(lua_State* L, std::size_t bytes);
void release_memory(lua_State* L, std::size_t bytes);

// [-0, +1]
void push_text(lua_State* L, std::string_view text);
// [-0, +0] Sets a field of the table on top.
void set_number(lua_State* L, const char* name, double value);
void set_integer(lua_State* L, const char* name, std::int64_t value);

// Tells which of two tables, functions, coroutines or full userdata was made first: it has the
// smaller number. Not for C functions without upvalues, which are not allocated.
std::uint64_t birth_of(lua_State* L, int index);

class Session;

// The session for which the bound functions of a state and all its coroutines work. Null if a state
// has none.
void set_session(lua_State* L, Session* session);
Session* find_session(lua_State* L);
// Requires a state with a session.
Session& session_of(lua_State* L);

}  // namespace hackle
