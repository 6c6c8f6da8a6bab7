// SPDX-License-Identifier: MIT
#include "console/lua/file_binding.hpp"

#include <filesystem>
#include <string_view>

#include "base/files.hpp"
#include "console/lua/guard.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

// Returns the file name at 1. In C it would end at a zero byte.
std::string name_at_1(lua_State* L, const std::string& who) {
  std::size_t size = 0;
  const char* text = luaL_checklstring(L, 1, &size);
  std::string name(text, size);
  if (name.empty() || name.find('\0') != std::string::npos)
    throw Error(ErrorKind::refused, who + ": the file name is empty or holds a zero byte");
  return name;
}

void replace_name(lua_State* L, const std::filesystem::path& path) {
  lua_pushstring(L, path.c_str());
  lua_replace(L, 1);
}

void replace_by_input(lua_State* L, const char* who) {
  replace_name(L, session_of(L).input_path(who, name_at_1(L, who)));
}

// Discards the output of a script that is only checked.
void replace_by_output(lua_State* L, const char* who) {
  Session& session = session_of(L);
  const auto path = session.output_path(who, name_at_1(L, who));
  session.names->claim(who, path, FileKind::text);
  if (session.settings.purpose != Purpose::results) return replace_name(L, "/dev/null");
  make_folder_of(path);
  replace_name(L, path);
}

// Calls Lua's own function with the present arguments.
int call_original(lua_State* L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

int open_file(lua_State* L) {
  const bool reads =
      std::string_view(luaL_optstring(L, 2, "r")).find_first_of("wa+") == std::string_view::npos;
  if (reads)
    replace_by_input(L, "io.open");
  else
    replace_by_output(L, "io.open");
  return call_original(L);
}

int lines_of_file(lua_State* L) {
  if (!lua_isnoneornil(L, 1)) replace_by_input(L, "io.lines");
  return call_original(L);
}

int set_input(lua_State* L) {
  if (lua_isstring(L, 1) != 0) replace_by_input(L, "io.input");
  return call_original(L);
}

int set_output(lua_State* L) {
  if (lua_isstring(L, 1) != 0) replace_by_output(L, "io.output");
  return call_original(L);
}

// [-0, +1] Compiles the file named at 1, or pushes the message.
bool load_file_at_1(lua_State* L, const char* who, const char* mode) {
  replace_by_input(L, who);
  return luaL_loadfilex(L, lua_tostring(L, 1), mode) == LUA_OK;
}

int load_file(lua_State* L) {
  const char* mode = session_of(L).settings.trust ? luaL_optstring(L, 2, nullptr) : "t";
  const bool has_environment = !lua_isnone(L, 3);
  lua_settop(L, 3);
  if (!load_file_at_1(L, "loadfile", mode)) {
    luaL_pushfail(L);
    lua_insert(L, -2);
    return 2;
  }
  if (!has_environment) return 1;
  lua_pushvalue(L, 3);
  if (lua_setupvalue(L, -2, 1) == nullptr) lua_pop(L, 1);
  return 1;
}

int do_file(lua_State* L) {
  lua_settop(L, 1);
  const char* mode = session_of(L).settings.trust ? nullptr : "t";
  if (!load_file_at_1(L, "dofile", mode)) return lua_error(L);
  lua_call(L, 0, LUA_MULTRET);
  return lua_gettop(L) - 1;
}

// Replaces a function of the table on top of the stack, and stores the original for the
// replacement.
void replace_function(lua_State* L, const char* name, lua_CFunction function) {
  lua_getfield(L, -1, name);
  lua_pushcclosure(L, function, 1);
  lua_setfield(L, -2, name);
}

}  // namespace

void open_files(lua_State* L) {
  lua_getglobal(L, "io");
  replace_function(L, "open", guarded<open_file>);
  replace_function(L, "lines", guarded<lines_of_file>);
  replace_function(L, "input", guarded<set_input>);
  replace_function(L, "output", guarded<set_output>);
  lua_pop(L, 1);
  lua_pushcfunction(L, guarded<load_file>);
  lua_setglobal(L, "loadfile");
  lua_pushcfunction(L, guarded<do_file>);
  lua_setglobal(L, "dofile");
}

}  // namespace hackle
