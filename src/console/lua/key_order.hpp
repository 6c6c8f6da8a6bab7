// SPDX-License-Identifier: MIT
// Tables are visited in one order in every process; that of Lua depends on addresses and on a seed
// that differs from process to process, and whatever a script sums or says in it does, too.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Exchanges pairs, which honours __pairs as before, and next. First come the whole numbers from
// 1 on; then the other numbers, ascending; texts, by their bytes; false, true; functions
// of the program; and tables, functions, threads and objects in the order in which they were made.
// Entries may be changed and removed on the way; whether one that is added is met stays open.
void open_key_order(lua_State* L);

}  // namespace hackle
