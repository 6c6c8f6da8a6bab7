// SPDX-License-Identifier: MIT
// Tables of results: to ask one for a member that it does not have is an error.
#pragma once

#include <span>
#include <string_view>

#include "console/lua/lua_state.hpp"

namespace hackle {

// Makes the table at the top one whose members are `names`, of which it may lack some: nil then.
// Any other name is refused, with the nearest of `names`. `noun` begins the message and stands for
// the kind of table: the names of a kind are those of its first table. Both must be static.
void close_names(lua_State* L, const char* noun, std::span<const std::string_view> names);

}  // namespace hackle
