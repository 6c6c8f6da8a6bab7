// SPDX-License-Identifier: MIT
// The border between C++ exceptions and errors of Lua. Every bound function is registered through
// guarded<>: what it throws reaches the script as an error object that keeps the kind, so that
// pcall works on it and the exit code survives. A script that is to stop (interrupt_hook.hpp) is
// stopped at its next call of one.
#pragma once

#include "console/lua/error_object.hpp"

namespace hackle {

using Binding = int (*)(lua_State*);
int call_guarded(lua_State* L, Binding function);

// As a lua_CFunction. Errors of Lua itself pass through untouched.
template <Binding function>
int guarded(lua_State* L) {
  return call_guarded(L, function);
}

}  // namespace hackle
