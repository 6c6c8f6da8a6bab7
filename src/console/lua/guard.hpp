// SPDX-License-Identifier: MIT
// The border between C++ exceptions and Lua errors. Every bound function is registered through
// guarded<>: an exception reaches the script as an error object that keeps the kind, so that pcall
// works and the exit code survives. A script that is to stop (interrupt_hook.hpp) stops at its next
// call of a bound function.
#pragma once

#include "console/lua/error_object.hpp"

namespace hackle {

using Binding = int (*)(lua_State*);
int call_guarded(lua_State* L, Binding function, const void* what);
// Calls a bound function, by way of the replay if the session has one; `what` tells which it is.
int call_replayed(lua_State* L, Binding function, const void* what);

// Wraps it as a lua_CFunction. Errors of Lua itself pass through unchanged.
template <Binding function>
int guarded(lua_State* L) {
  return call_guarded(L, function, reinterpret_cast<const void*>(&guarded<function>));
}

}  // namespace hackle
