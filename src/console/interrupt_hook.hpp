// SPDX-License-Identifier: MIT
// How Ctrl-C stops a script, whatever it does.
#pragma once

#include <optional>

#include "console/lua_state.hpp"

namespace hackle {

// Why nothing of this state may go on: it is interrupted, or the script called os.exit. An error of
// kind `interrupted`.
std::optional<Error> reason_to_stop(lua_State* L);

// Looks for one every 10 000 instructions of this state and of every coroutine that will be created
// in it, and raises it. Every bound function looks for one too (guard.hpp).
void watch_interrupts(lua_State* L);

// From now on looks at every instruction: a script that catches the first error with pcall is
// stopped at its next step.
void insist_on_interrupt(lua_State* L);

// Replaces what of Lua's library would let a script outlast that, as no hook is called in it:
// xpcall calls its handler while the error is being raised, and coroutine.wrap closes the variables
// of a coroutine that an error has ended.
void open_interruptible(lua_State* L);

}  // namespace hackle
