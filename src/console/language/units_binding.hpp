// SPDX-License-Identifier: MIT
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Defines the unit constants (mm, us, MPa, ...) as globals.
void open_units(lua_State* L);

// [-1, +1] Adds the unit constants as fields of the table on top of the stack.
void add_units(lua_State* L);

}  // namespace hackle
