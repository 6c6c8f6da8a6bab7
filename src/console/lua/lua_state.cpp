// SPDX-License-Identifier: MIT
#include "console/lua/lua_state.hpp"

#include <cassert>
#include <cstring>

#include <fmt/format.h>

#include "base/error.hpp"

namespace hackle {

namespace {

// An uncaught Lua error must not abort the program.
int panic(lua_State* L) {
  const bool text = lua_type(L, -1) == LUA_TSTRING;
  throw Error(ErrorKind::script, text ? lua_tostring(L, -1) : "(error without a text)");
}

LuaMemory& memory_of(lua_State* L) {
  void* memory = nullptr;
  lua_getallocf(L, &memory);
  return *static_cast<LuaMemory*>(memory);
}

// Returns the bytes between the block of a userdata without user values and its content.
std::ptrdiff_t head_of_userdata(lua_State* L) {
  const bool collects = lua_gc(L, LUA_GCISRUNNING) != 0;
  lua_gc(L, LUA_GCSTOP);
  const char* held = static_cast<const char*>(lua_newuserdatauv(L, 1, 0));
  const auto head = held - static_cast<const char*>(memory_of(L).newest());
  lua_pop(L, 1);
  if (collects) lua_gc(L, LUA_GCRESTART);
  return head;
}

}  // namespace

LuaState::LuaState(std::size_t max_memory)
    : memory_(max_memory), state_(lua_newstate(LuaMemory::allocate, &memory_)) {
  if (state_ == nullptr) throw Error(ErrorKind::run_failed, "no memory for a Lua state");
  set_session(state_, nullptr);
  lua_atpanic(state_, panic);
}

LuaState::~LuaState() {
  memory_.lift_limit();
  lua_close(state_);
}

Error out_of_memory(lua_State* L) {
  constexpr std::size_t bytes_a_megabyte = 1U << 20U;
  return {ErrorKind::script,
          fmt::format("not enough memory: the script's Lua values exceed {} MB",
                      memory_of(L).limit() / bytes_a_megabyte),
          "--lua-memory allows more"};
}

void hold_memory(lua_State* L, std::size_t bytes) {
  if (memory_of(L).hold(bytes)) return;
  lua_gc(L, LUA_GCCOLLECT);
  if (!memory_of(L).hold(bytes)) throw out_of_memory(L);
}

void release_memory(lua_State* L, std::size_t bytes) {
  memory_of(L).release(bytes);
}

void push_text(lua_State* L, std::string_view text) {
  lua_pushlstring(L, text.data(), text.size());
}

void set_number(lua_State* L, const char* name, double value) {
  lua_pushnumber(L, value);
  lua_setfield(L, -2, name);
}

void set_integer(lua_State* L, const char* name, std::int64_t value) {
  lua_pushinteger(L, value);
  lua_setfield(L, -2, name);
}

std::uint64_t birth_of(lua_State* L, int index) {
  const char* object = static_cast<const char*>(lua_topointer(L, index));
  if (lua_isthread(L, index)) object -= LUA_EXTRASPACE;
  if (lua_isuserdata(L, index)) object -= head_of_userdata(L);
  return LuaMemory::birth_of(object);
}

// Lua reserves the size of a pointer for its host in every state; a new coroutine gets a copy of
// the main state's.
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
