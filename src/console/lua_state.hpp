// SPDX-License-Identifier: MIT
// A Lua 5.4 state in its C++ build: errors of Lua are C++ exceptions, so destructors run when one
// passes. They are not std::exception; catch (...) around a call of Lua would swallow them.
#pragma once

#include <lua.hpp>

namespace hackle {

class LuaState {
 public:
  // Opens the standard libraries. Throws Error (run_failed) when there is no memory for it.
  LuaState();
  ~LuaState();
  LuaState(const LuaState&) = delete;
  LuaState& operator=(const LuaState&) = delete;

  lua_State* get() const { return state_; }
  operator lua_State*() const { return state_; }

 private:
  lua_State* state_;
};

class Session;

// The session that the bound functions of a state and of all its coroutines work for. Null in a
// state that has none.
void set_session(lua_State* L, Session* session);
Session* find_session(lua_State* L);
// Of a state that has one.
Session& session_of(lua_State* L);

}  // namespace hackle
