// SPDX-License-Identifier: MIT
// require for an untrusted script: Lua text modules in folders that it may read.
#pragma once

#include <filesystem>

#include "console/lua/lua_state.hpp"

namespace hackle {

// Keeps package.preload and one searcher, which goes through package.path and checks each file with
// the Sandbox, and a package.searchpath that does the same.
void open_modules(lua_State* L);

// Searches modules beside the script that requires them, then in Hackle's `scripts`; for a trusted
// script also where Lua itself searches.
void look_for_modules_in(lua_State* L, const std::filesystem::path& folder);

}  // namespace hackle
