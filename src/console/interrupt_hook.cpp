// SPDX-License-Identifier: MIT
#include "console/interrupt_hook.hpp"

#include "base/interrupt.hpp"
#include "console/guard.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

constexpr int instructions_between_looks = 10000;

void look(lua_State* L, lua_Debug*) {
  const Session* session = find_session(L);
  const bool leaving = session != nullptr && session->exit_code.has_value();
  if (!leaving && !interrupted()) return;
  insist_on_interrupt(L);
  push_error(L, Error(ErrorKind::interrupted, leaving ? "os.exit" : "interrupted"), place(L, 0));
  lua_error(L);
}

lua_State* main_thread(lua_State* L) {
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_MAINTHREAD);
  lua_State* main = lua_tothread(L, -1);
  lua_pop(L, 1);
  return main;
}

}  // namespace

void watch_interrupts(lua_State* L) {
  lua_sethook(L, look, LUA_MASKCOUNT, instructions_between_looks);
}

void insist_on_interrupt(lua_State* L) {
  lua_sethook(L, look, LUA_MASKCOUNT, 1);
  lua_sethook(main_thread(L), look, LUA_MASKCOUNT, 1);
}

}  // namespace hackle
