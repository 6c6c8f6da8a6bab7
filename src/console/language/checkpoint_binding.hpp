// SPDX-License-Identifier: MIT
// Simulations to and from files: s:save and load.
#pragma once

#include <span>

#include "console/schema/object_type.hpp"

namespace hackle {

std::span<const Function> checkpoint_methods();  // of simulations
std::span<const Function> checkpoint_functions();

// [-0, +0] Keeps Lua's own load, which load calls for anything but a checkpoint; to be called
// before the functions are opened.
void keep_load_of_lua(lua_State* L);

}  // namespace hackle
