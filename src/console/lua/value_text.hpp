// SPDX-License-Identifier: MIT
// Formats a Lua value for a person at the prompt.
#pragma once

#include <string>

#include "console/lua/lua_state.hpp"

namespace hackle {

// [-0, +0] Returns a text unchanged; a table with its contents, `{1, 2, x = "a", ...}`, list part
// first and keys in order, to a depth of three and forty entries each; any other value as by
// tostring. May call __tostring and throw its errors, so call it from within Lua.
std::string value_text(lua_State* L, int index);

}  // namespace hackle
