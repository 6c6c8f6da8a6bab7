// SPDX-License-Identifier: MIT
// require for a script from a stranger: modules of Lua text that lie where it may read.
#pragma once

#include <filesystem>

#include "console/lua/lua_state.hpp"

namespace hackle {

// Leaves package.preload and one searcher, which goes through package.path and asks the Sandbox
// about each file, and a package.searchpath that does the same.
void open_modules(lua_State* L);

// Modules lie beside the script that requires them; for a script that is trusted also where Lua
// itself looks.
void look_for_modules_in(lua_State* L, const std::filesystem::path& folder);

}  // namespace hackle
