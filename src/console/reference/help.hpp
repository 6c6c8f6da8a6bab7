// SPDX-License-Identifier: MIT
// The answers of help().
#pragma once

#include <string>

#include "console/lua/lua_state.hpp"

namespace hackle {

// [-0, +0] Explains the first value on the stack: nothing, a function, a text or an object. Throws
// Error (refused) if nothing is known about it.
std::string help_on(lua_State* L);

}  // namespace hackle
