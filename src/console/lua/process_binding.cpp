// SPDX-License-Identifier: MIT
#include "console/lua/process_binding.hpp"

#include <cstdio>

#include "base/streams.hpp"
#include "console/lua/guard.hpp"
#include "console/lua/interrupt_hook.hpp"
#include "console/lua/object_name.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

int exit_script(lua_State* L) {
  int code = 0;
  if (lua_isboolean(L, 1))
    code = lua_toboolean(L, 1) != 0 ? 0 : 1;
  else if (!lua_isnoneornil(L, 1))
    code = static_cast<int>(luaL_checkinteger(L, 1));
  session_of(L).leave(code);
}

int print(lua_State* L) {
  Session& session = session_of(L);
  if (session.settings.purpose != Purpose::results || session.settings.only_verdicts) return 0;
  std::FILE* stream = session.settings.print_to_stderr ? stderr : stdout;
  const int count = lua_gettop(L);
  ++session.said;
  if (session.make_room) session.make_room();
  for (int i = 1; i <= count; ++i) {
    std::size_t size = 0;
    const char* text = push_name(L, i, &size);
    if (i > 1) write_to(stream, "\t");
    write_to(stream, {text, size});
    lua_pop(L, 1);
  }
  write_to(stream, "\n");
  flush(stream);
  return 0;
}

}  // namespace

void open_exit(lua_State* L) {
  lua_getglobal(L, "os");
  lua_pushcfunction(L, guarded<exit_script>);
  lua_setfield(L, -2, "exit");
  lua_pop(L, 1);
  for (const char* name : {"exit", "quit"}) {
    lua_pushcfunction(L, guarded<exit_script>);
    lua_setglobal(L, name);
  }
}

bool is_exit(lua_State* L, int index) {
  return lua_tocfunction(L, index) == &guarded<exit_script>;
}

void open_print(lua_State* L) {
  lua_pushcfunction(L, print);
  lua_setglobal(L, "print");
  if (!session_of(L).settings.print_to_stderr) return;
  luaL_loadstring(L, "io.output(io.stderr)");
  protected_call(L, 0, 0);
}

}  // namespace hackle
