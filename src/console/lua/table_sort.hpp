// SPDX-License-Identifier: MIT
// A stable table.sort. Lua's own chooses pivots of long lists by the clock: for elements that
// compare equal, its order differs from process to process.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Replaces table.sort. An inconsistent order function raises no error.
void open_table_sort(lua_State* L);

}  // namespace hackle
