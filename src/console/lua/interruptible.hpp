// SPDX-License-Identifier: MIT
// Replacements for functions of Lua's library that would outlast an interrupt.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Replaces the functions of Lua's library with which a script could outlast an interrupt
// (interrupt_hook.hpp), because no hook is called in them: xpcall calls its handler while the error
// is being raised, and coroutine.wrap closes the variables of a coroutine that an error has ended.
void open_interruptible(lua_State* L);

}  // namespace hackle
