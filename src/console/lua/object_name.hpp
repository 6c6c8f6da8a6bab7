// SPDX-License-Identifier: MIT
// "table: 3": the text of a value that has none of its own. Lua would write its address, which
// differs in every process.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// [-0, +1] Like luaL_tolstring, but tables, functions, coroutines and userdata without their own
// text are numbered in the order in which their text was first requested.
const char* push_name(lua_State* L, int index, std::size_t* size = nullptr);

// Makes tostring and string.format, %p included, and files use these names.
void open_object_names(lua_State* L);

}  // namespace hackle
