// SPDX-License-Identifier: MIT
// How Ctrl-C stops a script that computes in Lua.
#pragma once

#include "console/lua_state.hpp"

namespace hackle {

// Looks at interrupted() every 10 000 instructions of this state and of every coroutine that will
// be created in it, and raises an error of kind `interrupted`. Also ends a script that called
// os.exit.
void watch_interrupts(lua_State* L);

// From now on looks at every instruction: a script that catches the first error with pcall is
// stopped at its next step.
void insist_on_interrupt(lua_State* L);

}  // namespace hackle
