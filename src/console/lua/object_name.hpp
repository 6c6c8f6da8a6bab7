// SPDX-License-Identifier: MIT
// "table: 3": the text of what has none of its own. Lua writes its address, which is another in
// every process.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// [-0, +1] As luaL_tolstring, but tables, functions, coroutines and userdata without a text of
// their own are counted: the number is that of those whose text was asked for before, plus one.
const char* push_name(lua_State* L, int index, std::size_t* size = nullptr);

// Lets tostring and string.format write so, %p too, and files.
void open_object_names(lua_State* L);

}  // namespace hackle
