// SPDX-License-Identifier: MIT
// A value of Lua as a person at the prompt wants to see it.
#pragma once

#include <string>

#include "console/lua/lua_state.hpp"

namespace hackle {

// [-0, +0] A text as it is; a table with what it holds, `{1, 2, x = "a", ...}`, its list first and
// its keys in order, to a depth of three and forty entries each; anything else as tostring has it.
// May call __tostring and throw what that throws, so it wants to be called from within Lua.
std::string value_text(lua_State* L, int index);

}  // namespace hackle
