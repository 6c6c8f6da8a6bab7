// SPDX-License-Identifier: MIT
// table.sort that leaves equal elements in their order. Lua's picks its pivots of long lists by the
// clock: where elements are equal to the function that compares them, its order is another in every
// process.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Exchanges table.sort. An order function that contradicts itself raises no error.
void open_table_sort(lua_State* L);

}  // namespace hackle
