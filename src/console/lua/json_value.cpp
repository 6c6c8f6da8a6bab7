// SPDX-License-Identifier: MIT
#include "console/lua/json_value.hpp"

#include <nlohmann/json.hpp>

namespace hackle {

void push_json(lua_State* L, const nlohmann::ordered_json& json) {
  luaL_checkstack(L, 4, "deep JSON");
  if (json.is_boolean()) return lua_pushboolean(L, json.get<bool>());
  if (json.is_number_integer()) return lua_pushinteger(L, json.get<std::int64_t>());
  if (json.is_number()) return lua_pushnumber(L, json.get<double>());
  if (json.is_string()) return push_text(L, json.get_ref<const std::string&>());
  if (json.is_null()) return lua_pushnil(L);
  lua_newtable(L);
  lua_Integer place = 0;
  for (const auto& entry : json.items()) {
    push_json(L, entry.value());
    if (json.is_array())
      lua_rawseti(L, -2, ++place);
    else
      lua_setfield(L, -2, entry.key().c_str());
  }
}

}  // namespace hackle
