// SPDX-License-Identifier: MIT
// Calls for files whose options are constant, such as s:frame { "a.png", field = "damage" }, are
// checked before a script begins: a slip in its last line does not cost the run before it.
#pragma once

#include <string>
#include <string_view>

#include "base/error.hpp"
#include "console/lua/lua_state.hpp"

namespace hackle {

// Returns the problems of the calls of frame, movie and record in a script, each after its place in
// `script_name`. A call counts as constant if it holds numbers, texts, units and operators alone; a
// name that the script itself makes is no unit. The script need not be valid Lua.
Problems problems_of_constant_calls(lua_State* L, std::string_view text,
                                    const std::string& script_name);

}  // namespace hackle
