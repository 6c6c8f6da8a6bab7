// SPDX-License-Identifier: MIT
#include "console/lua_state.hpp"

#include <cassert>
#include <cstring>

#include "base/error.hpp"

namespace hackle {

LuaState::LuaState() : state_(luaL_newstate()) {
  if (state_ == nullptr) throw Error(ErrorKind::run_failed, "no memory for a Lua state");
  set_session(state_, nullptr);
  luaL_openlibs(state_);
}

LuaState::~LuaState() {
  lua_close(state_);
}

// Lua keeps the size of a pointer for its host in every state; a new coroutine gets a copy of the
// main one's.
void set_session(lua_State* L, Session* session) {
  std::memcpy(lua_getextraspace(L), &session, LUA_EXTRASPACE);
}

Session* find_session(lua_State* L) {
  Session* session = nullptr;
  std::memcpy(&session, lua_getextraspace(L), LUA_EXTRASPACE);
  return session;
}

Session& session_of(lua_State* L) {
  Session* session = find_session(L);
  assert(session != nullptr);
  return *session;
}

}  // namespace hackle
