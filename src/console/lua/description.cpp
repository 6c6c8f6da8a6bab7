// SPDX-License-Identifier: MIT
#include "console/lua/description.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "console/lua/object.hpp"

namespace hackle {
namespace {

constexpr std::size_t longest_quote = 40;

std::string name_of_object(lua_State* L, int index) {
  std::string name = "userdata";
  if (luaL_getmetafield(L, index, "__name") != LUA_TNIL) {
    if (lua_type(L, -1) == LUA_TSTRING) name = lua_tostring(L, -1);
    lua_pop(L, 1);
  }
  if (name.starts_with(type_prefix)) name.erase(0, type_prefix.size());
  return "a " + name;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  if (text.size() <= longest_quote) return fmt::format("'{}'", text);
  return fmt::format("'{}...'", text.substr(0, longest_quote));
}

std::string_view text_at(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = lua_tolstring(L, index, &size);
  return {text, size};
}

std::string number_text(double value) {
  return std::isnan(value) ? "nan" : shortest(value);
}

std::string description(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNONE:
    case LUA_TNIL:
      return "nothing";
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) ? "true" : "false";
    case LUA_TNUMBER:
      return lua_isinteger(L, index) ? std::to_string(lua_tointeger(L, index))
                                     : number_text(lua_tonumber(L, index));
    case LUA_TSTRING:
      return "the text " + in_quotes(text_at(L, index));
    case LUA_TUSERDATA:
      return name_of_object(L, index);
    default:
      return fmt::format("a {}", luaL_typename(L, index));
  }
}

}  // namespace hackle
