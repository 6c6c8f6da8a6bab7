// SPDX-License-Identifier: MIT
// JSON as values of Lua.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "console/lua/lua_state.hpp"

namespace hackle {

// [-0, +1] Pushes objects and arrays as tables; null in an object is a member that is not there.
void push_json(lua_State* L, const nlohmann::ordered_json& json);

}  // namespace hackle
