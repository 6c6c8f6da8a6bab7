// SPDX-License-Identifier: MIT
// The functions of Lua's library that open files by name.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Replaces io.open, io.lines, io.input, io.output, loadfile and dofile: names are resolved as
// everywhere in Hackle, by Session::input_path and output_path, which refuse files that a script
// may not reach. Output of a script that is only checked is discarded.
void open_files(lua_State* L);

}  // namespace hackle
