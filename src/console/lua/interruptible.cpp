// SPDX-License-Identifier: MIT
#include "console/lua/interruptible.hpp"

#include "console/lua/guard.hpp"
#include "console/lua/interrupt_hook.hpp"

namespace hackle {
namespace {

bool is_interrupt(lua_State* L, int index) {
  const Error* error = object_at<Error>(L, index);
  return error != nullptr && error->kind() == ErrorKind::interrupted;
}

// Calls the script's handler, the first upvalue, for all other errors.
int handle(lua_State* L) {
  if (is_interrupt(L, 1)) return 1;
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 1);
  return 1;
}

int all_results(lua_State* L, int, lua_KContext) {
  return lua_gettop(L);
}

// Lua's own function is the first upvalue. The called function may yield.
int protected_call_with_handler(lua_State* L) {
  luaL_checktype(L, 2, LUA_TFUNCTION);
  lua_pushvalue(L, 2);
  lua_pushcclosure(L, handle, 1);
  lua_replace(L, 2);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_callk(L, lua_gettop(L) - 1, LUA_MULTRET, 0, all_results);
  return all_results(L, LUA_OK, 0);
}

// The upvalues of a function from coroutine.wrap.
constexpr int coroutine_itself = 1, resume_function = 2, close_function = 3;

// Raises the error on top of the stack, which comes from the coroutine: closes the coroutine, which
// may replace the error, and adds the place of the call.
int raise_from_coroutine(lua_State* L) {
  lua_State* coroutine = lua_tothread(L, lua_upvalueindex(coroutine_itself));
  const int status = lua_status(coroutine);
  if (status != LUA_OK && status != LUA_YIELD && !is_interrupt(L, -1)) {
    lua_pushvalue(L, lua_upvalueindex(close_function));
    lua_pushvalue(L, lua_upvalueindex(coroutine_itself));
    lua_call(L, 1, 2);
    if (lua_isnil(L, -1)) lua_pop(L, 2);  // no error replaces it
  }
  if (status != LUA_ERRMEM && lua_type(L, -1) == LUA_TSTRING) {
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
  }
  return lua_error(L);
}

int go_on_with_coroutine(lua_State* L) {
  const InterruptTarget target(lua_tothread(L, lua_upvalueindex(coroutine_itself)));
  lua_pushvalue(L, lua_upvalueindex(resume_function));
  lua_pushvalue(L, lua_upvalueindex(coroutine_itself));
  lua_rotate(L, 1, 2);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  if (lua_toboolean(L, 1) == 0) return raise_from_coroutine(L);
  return lua_gettop(L) - 1;
}

// The upvalues are Lua's create, resume and close.
int wrap(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  lua_pushvalue(L, lua_upvalueindex(2));
  lua_pushvalue(L, lua_upvalueindex(3));
  lua_pushcclosure(L, guarded<go_on_with_coroutine>, 3);
  return 1;
}

int resume_coroutine(lua_State* L) {
  const InterruptTarget target(lua_tothread(L, 1));
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

}  // namespace

void open_interruptible(lua_State* L) {
  lua_getglobal(L, "xpcall");
  lua_pushcclosure(L, protected_call_with_handler, 1);
  lua_setglobal(L, "xpcall");
  lua_getglobal(L, "coroutine");
  lua_getfield(L, -1, "create");
  lua_getfield(L, -2, "resume");
  lua_getfield(L, -3, "close");
  lua_pushcclosure(L, wrap, 3);
  lua_setfield(L, -2, "wrap");
  lua_getfield(L, -1, "resume");
  lua_pushcclosure(L, guarded<resume_coroutine>, 1);
  lua_setfield(L, -2, "resume");
  lua_pop(L, 1);
}

}  // namespace hackle
