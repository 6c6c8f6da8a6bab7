// SPDX-License-Identifier: MIT
// What of Lua's library would outlast an interrupt, in a form that does not.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Replaces what of Lua's library would let a script outlast an interrupt (interrupt_hook.hpp), as
// no hook is called in it: xpcall calls its handler while the error is being raised, and
// coroutine.wrap closes the variables of a coroutine that an error has ended.
void open_interruptible(lua_State* L);

}  // namespace hackle
