// SPDX-License-Identifier: MIT
// What help() tells about what it is given.
#pragma once

#include <string>

#include "console/lua/lua_state.hpp"

namespace hackle {

// [-0, +0] About the first value of the stack: nothing, a function, a text or an object. Throws
// Error (refused) when nothing is known of it.
std::string help_on(lua_State* L);

}  // namespace hackle
