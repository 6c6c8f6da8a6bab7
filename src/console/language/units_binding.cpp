// SPDX-License-Identifier: MIT
#include "console/language/units_binding.hpp"

#include "base/units.hpp"

namespace hackle {

void open_units(lua_State* L) {
  lua_pushglobaltable(L);
  add_units(L);
  lua_pop(L, 1);
}

void add_units(lua_State* L) {
  for (const Unit& unit : units()) {
    lua_pushlstring(L, unit.name.data(), unit.name.size());
    lua_pushnumber(L, unit.factor);
    lua_rawset(L, -3);
  }
}

}  // namespace hackle
