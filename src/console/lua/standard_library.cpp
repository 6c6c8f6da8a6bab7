// SPDX-License-Identifier: MIT
#include "console/lua/standard_library.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "console/lua/file_binding.hpp"
#include "console/lua/guard.hpp"
#include "console/lua/interruptible.hpp"
#include "console/lua/key_order.hpp"
#include "console/lua/module_binding.hpp"
#include "console/lua/object_name.hpp"
#include "console/lua/table_sort.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

using NameList = std::span<const std::string_view>;

constexpr auto globals = std::to_array<std::string_view>(
    {"_G",       "_VERSION",     "assert",   "collectgarbage", "coroutine",
     "debug",    "dofile",       "error",    "getmetatable",   "io",
     "ipairs",   "load",         "loadfile", "math",           "next",
     "os",       "package",      "pairs",    "pcall",          "print",
     "rawequal", "rawget",       "rawlen",   "rawset",         "require",
     "select",   "setmetatable", "string",   "table",          "tonumber",
     "tostring", "type",         "utf8",     "xpcall"});
constexpr auto in_coroutine = std::to_array<std::string_view>(
    {"close", "create", "isyieldable", "resume", "running", "status", "wrap", "yield"});
constexpr auto in_debug = std::to_array<std::string_view>({"traceback"});
constexpr auto in_io =
    std::to_array<std::string_view>({"close", "flush", "input", "lines", "open", "output", "read",
                                     "stderr", "stdin", "stdout", "type", "write"});
constexpr auto in_math = std::to_array<std::string_view>(
    {"abs",  "acos",   "asin",       "atan", "ceil",       "cos", "deg",        "exp",  "floor",
     "fmod", "huge",   "log",        "max",  "maxinteger", "min", "mininteger", "modf", "pi",
     "rad",  "random", "randomseed", "sin",  "sqrt",       "tan", "tointeger",  "type", "ult"});
constexpr auto in_os =
    std::to_array<std::string_view>({"clock", "date", "difftime", "exit", "time"});
constexpr auto in_package = std::to_array<std::string_view>(
    {"config", "loaded", "path", "preload", "searchers", "searchpath"});
constexpr auto in_string = std::to_array<std::string_view>(
    {"byte", "char", "find", "format", "gmatch", "gsub", "len", "lower", "match", "pack",
     "packsize", "rep", "reverse", "sub", "unpack", "upper"});
constexpr auto in_table = std::to_array<std::string_view>(
    {"concat", "insert", "move", "pack", "remove", "sort", "unpack"});
constexpr auto in_utf8 =
    std::to_array<std::string_view>({"char", "charpattern", "codepoint", "codes", "len", "offset"});

struct Library {
  const char* name;
  NameList names;
};
const std::array libraries{
    Library{LUA_GNAME, globals},          Library{LUA_COLIBNAME, in_coroutine},
    Library{LUA_DBLIBNAME, in_debug},     Library{LUA_IOLIBNAME, in_io},
    Library{LUA_MATHLIBNAME, in_math},    Library{LUA_OSLIBNAME, in_os},
    Library{LUA_LOADLIBNAME, in_package}, Library{LUA_STRLIBNAME, in_string},
    Library{LUA_TABLIBNAME, in_table},    Library{LUA_UTF8LIBNAME, in_utf8}};

// Removes all other functions from the table on top of the stack.
void keep_only(lua_State* L, NameList names) {
  for (lua_pushnil(L); lua_next(L, -2) != 0;) {
    lua_pop(L, 1);
    if (std::ranges::find(names, lua_tostring(L, -1)) != names.end()) continue;
    lua_pushvalue(L, -1);
    lua_pushnil(L);
    lua_rawset(L, -4);
  }
}

// Like Lua's load, but the mode is always "t".
int load_text(lua_State* L) {
  if (lua_gettop(L) < 3) lua_settop(L, 3);
  lua_pushliteral(L, "t");
  lua_replace(L, 3);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

// Like Lua's setmetatable, but without finalizers.
int set_metatable(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_argexpected(L, lua_isnil(L, 2) || lua_istable(L, 2), 2, "nil or table");
  if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL)
    return luaL_error(L, "cannot change a protected metatable");
  lua_settop(L, 2);
  lua_pushliteral(L, "__gc");
  if (lua_istable(L, 2) && lua_rawget(L, 2) != LUA_TNIL)
    throw Error(ErrorKind::refused, "setmetatable: __gc is not allowed, Ctrl-C would not stop it",
                "__close with a local <close> does much the same; hackle --trust lifts this");
  lua_settop(L, 2);
  lua_setmetatable(L, 1);
  return 1;
}

// Like Lua's math.randomseed, which without a number starts at random; here it starts at 0.
int seed_random(lua_State* L) {
  if (lua_gettop(L) == 0)
    lua_pushinteger(L, 0);
  else
    luaL_checknumber(L, 1);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

// Lua 5.4 seeds at random, so that a script would never do the same twice.
void open_random(lua_State* L) {
  lua_getglobal(L, "math");
  lua_getfield(L, -1, "randomseed");
  lua_pushcclosure(L, seed_random, 1);
  lua_pushvalue(L, -1);
  lua_setfield(L, -3, "randomseed");
  lua_call(L, 0, 0);
  lua_pop(L, 1);
}

// Fixes everything in Lua that differs from process to process.
void fix_order(lua_State* L) {
  open_random(L);
  open_key_order(L);
  open_table_sort(L);
  open_object_names(L);
}

void guard_globals(lua_State* L) {
  lua_pushglobaltable(L);
  lua_getfield(L, -1, "load");
  lua_pushcclosure(L, load_text, 1);
  lua_setfield(L, -2, "load");
  lua_pushcfunction(L, guarded<set_metatable>);
  lua_setfield(L, -2, "setmetatable");
  lua_pop(L, 1);
}

// Otherwise a script could replace the finalizer of files.
void hide_metatable_of_files(lua_State* L) {
  luaL_getmetatable(L, LUA_FILEHANDLE);
  lua_pushliteral(L, "file");
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
}

void cut_down(lua_State* L) {
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  for (const Library& library : libraries) {
    lua_getfield(L, -1, library.name);
    keep_only(L, library.names);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
}

int pretend(lua_State* L) {
  lua_pushboolean(L, 1);
  return 1;
}

int refuse_to_act(lua_State*) {
  throw Error(ErrorKind::refused, "a script that is checked changes nothing outside of it");
}

void replace(lua_State* L, const char* library, const char* name, lua_CFunction function) {
  lua_getglobal(L, library);
  lua_pushcfunction(L, function);
  lua_setfield(L, -2, name);
  lua_pop(L, 1);
}

// Disables everything by which a trusted script that is only checked could have an effect outside.
// Files opened for writing are handled where they are opened (file_binding.hpp).
void hold_back(lua_State* L) {
  for (const char* name : {"remove", "rename"}) replace(L, "os", name, pretend);
  for (const char* name : {"execute", "tmpname"}) replace(L, "os", name, guarded<refuse_to_act>);
  replace(L, "io", "popen", guarded<refuse_to_act>);
}

}  // namespace

void open_standard_library(lua_State* L) {
  luaL_openlibs(L);
  fix_order(L);
  open_files(L);
  open_interruptible(L);
  const ConsoleSettings& settings = session_of(L).settings;
  if (settings.trust && settings.purpose != Purpose::results) hold_back(L);
  if (settings.trust) return;
  open_modules(L);
  guard_globals(L);
  hide_metatable_of_files(L);
  cut_down(L);
}

}  // namespace hackle
