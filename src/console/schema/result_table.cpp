// SPDX-License-Identifier: MIT
#include "console/schema/result_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "console/lua/description.hpp"
#include "console/lua/guard.hpp"

namespace hackle {
namespace {

using Names = std::span<const std::string_view>;

int refuse_name(lua_State* L) {
  const char* noun = static_cast<const char*>(lua_touserdata(L, lua_upvalueindex(1)));
  const Names names(static_cast<const std::string_view*>(lua_touserdata(L, lua_upvalueindex(2))),
                    static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(3))));
  const bool text = lua_type(L, 2) == LUA_TSTRING;
  const std::string name = text ? lua_tostring(L, 2) : description(L, 2);
  if (text && std::ranges::find(names, name) != names.end()) return 0;
  throw Error(ErrorKind::refused,
              fmt::format("{} has no '{}'{}", noun, name.substr(0, 40), did_you_mean(name, names)),
              "it has " + comma_list({names.begin(), names.end()}));
}

}  // namespace

void close_names(lua_State* L, const char* noun, Names names) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, noun) == LUA_TNIL) {
    lua_pop(L, 1);
    lua_createtable(L, 0, 1);
    lua_pushlightuserdata(L, const_cast<char*>(noun));
    lua_pushlightuserdata(L, const_cast<std::string_view*>(names.data()));
    lua_pushinteger(L, std::ssize(names));
    lua_pushcclosure(L, guarded<refuse_name>, 3);
    lua_setfield(L, -2, "__index");
    lua_pushvalue(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, noun);
  }
  lua_setmetatable(L, -2);
}

}  // namespace hackle
