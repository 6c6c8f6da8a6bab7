// SPDX-License-Identifier: MIT
#include "console/lua/object_name.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace hackle {
namespace {

bool is_addressed(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TTABLE:
    case LUA_TFUNCTION:
    case LUA_TTHREAD:
    case LUA_TUSERDATA:
    case LUA_TLIGHTUSERDATA:
      return true;
    default:
      return false;
  }
}

bool has_own_text(lua_State* L, int index) {
  if (luaL_getmetafield(L, index, "__tostring") == LUA_TNIL) return false;
  lua_pop(L, 1);
  return true;
}

// [-0, +1] Pushes the table from object to number, while objects live; entry 0 is the count so far.
void push_numbers(lua_State* L) {
  if (luaL_getsubtable(L, LUA_REGISTRYINDEX, "hackle.names") != 0) return;
  lua_createtable(L, 0, 1);
  lua_pushliteral(L, "k");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
}

lua_Integer number_of_object(lua_State* L, int index) {
  push_numbers(L);
  const int numbers = lua_gettop(L);
  lua_pushvalue(L, index);
  if (lua_rawget(L, numbers) == LUA_TNIL) {
    lua_rawgeti(L, numbers, 0);
    lua_pushinteger(L, lua_tointeger(L, -1) + 1);
    lua_pushvalue(L, -1);
    lua_rawseti(L, numbers, 0);
    lua_pushvalue(L, index);
    lua_pushvalue(L, -2);
    lua_rawset(L, numbers);
  }
  const lua_Integer number = lua_tointeger(L, -1);
  lua_settop(L, numbers - 1);
  return number;
}

// [-0, +1] Pushes the name that Lua would write before the address.
void push_kind(lua_State* L, int index) {
  const int kind = luaL_getmetafield(L, index, "__name");
  if (kind == LUA_TSTRING) return;
  if (kind != LUA_TNIL) lua_pop(L, 1);
  lua_pushstring(L, luaL_typename(L, index));
}

int name_to_text(lua_State* L) {
  luaL_checkany(L, 1);
  push_name(L, 1);
  return 1;
}

// Like Lua's, for open and closed files.
int file_to_text(lua_State* L) {
  lua_settop(L, 1);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  if (std::string_view(lua_tostring(L, -1)) == "file (closed)") return 1;
  lua_pushfstring(L, "file (%I)", static_cast<LUAI_UACINT>(number_of_object(L, 1)));
  return 1;
}

// Returns the end of the conversion at `at`, after flags, width and precision.
std::size_t end_of_conversion(std::string_view format, std::size_t at) {
  return std::min(format.find_first_not_of("-+ #0123456789.", at), format.size());
}

// [-1, +1] Adds name and place to a Lua error, which lacks them in a wrapped function.
int say_place(lua_State* L) {
  if (lua_type(L, -1) != LUA_TSTRING) return lua_error(L);
  luaL_where(L, 1);
  luaL_gsub(L, lua_tostring(L, -2), "'?'", "'format'");
  lua_concat(L, 2);
  return lua_error(L);
}

// Like Lua's, but conversions s and p get the names of objects.
int format_names(lua_State* L) {
  std::size_t size = 0;
  const char* given = luaL_checklstring(L, 1, &size);
  std::string text(given, size);
  const int count = lua_gettop(L);
  int argument = 1;
  for (std::size_t at = 0; (at = text.find('%', at)) < text.size(); ++at) {
    at = end_of_conversion(text, at + 1);
    if (at == text.size()) break;
    if (text[at] == '%') continue;
    if (++argument > count) break;
    const bool pointer = text[at] == 'p';
    if (pointer) text[at] = 's';
    if ((pointer || text[at] == 's') && is_addressed(L, argument)) {
      push_name(L, argument);
      lua_replace(L, argument);
    }
  }
  lua_pushlstring(L, text.data(), text.size());
  lua_replace(L, 1);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  if (lua_pcall(L, count, 1, 0) != LUA_OK) return say_place(L);
  return 1;
}

}  // namespace

const char* push_name(lua_State* L, int index, std::size_t* size) {
  if (!is_addressed(L, index) || has_own_text(L, index)) return luaL_tolstring(L, index, size);
  index = lua_absindex(L, index);
  luaL_checkstack(L, 8, "no room for a name");
  push_kind(L, index);
  lua_pushfstring(L, "%s: %I", lua_tostring(L, -1),
                  static_cast<LUAI_UACINT>(number_of_object(L, index)));
  lua_remove(L, -2);
  return lua_tolstring(L, -1, size);
}

void open_object_names(lua_State* L) {
  lua_pushcfunction(L, name_to_text);
  lua_setglobal(L, "tostring");
  lua_getglobal(L, "string");
  lua_getfield(L, -1, "format");
  lua_pushcclosure(L, format_names, 1);
  lua_setfield(L, -2, "format");
  luaL_getmetatable(L, LUA_FILEHANDLE);
  lua_getfield(L, -1, "__tostring");
  lua_pushcclosure(L, file_to_text, 1);
  lua_setfield(L, -2, "__tostring");
  lua_pop(L, 2);
}

}  // namespace hackle
