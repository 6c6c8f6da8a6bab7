// SPDX-License-Identifier: MIT
// The forces on what holds, leads or meets a plate.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "console/schema/schema.hpp"

namespace hackle {

inline constexpr auto reaction_keys = std::to_array<std::string_view>(
    {"name", "body", "number", "x", "y", "fx", "fy", "moment", "ux", "uy"});

// [-0, +1] Of the simulation at index 1, as a list.
int push_reactions(lua_State* L);

std::span<const Function> reaction_methods();

}  // namespace hackle
