// SPDX-License-Identifier: MIT
// What of Lua's own library must know that simulations are open: print and os.exit.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// os.exit ends the script, not the process, so that every simulation is closed first.
void open_exit(lua_State* L);

// print makes room on the screen first. Where the session says so, print and io.write go to stderr.
void open_print(lua_State* L);

}  // namespace hackle
