// SPDX-License-Identifier: MIT
// Makes the traversal order of tables the same in every process. Lua's own order depends on
// addresses and on a seed per process, and so would any sum or output of a script over it.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Replaces pairs, which still honours __pairs, and next. The order is: whole numbers from 1; other
// numbers, ascending; texts, by their bytes; false, true; functions of the program; then tables,
// functions, threads and objects in the order of their creation. Entries may be changed and removed
// during a traversal; whether an added entry is visited is undefined.
void open_key_order(lua_State* L);

}  // namespace hackle
