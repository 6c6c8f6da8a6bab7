// SPDX-License-Identifier: MIT
// Functions of Lua's library that must respect open simulations: print and os.exit.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Makes os.exit, which is also exit and quit, end the script, not the process, so that every
// simulation is closed first.
void open_exit(lua_State* L);
// Returns whether the value is that function: at the prompt the bare word is enough to leave.
bool is_exit(lua_State* L, int index);

// Makes print clear the prompt's line first. If the session says so, print and io.write go to
// stderr.
void open_print(lua_State* L);

}  // namespace hackle
