// SPDX-License-Identifier: MIT
// What of Lua's own library opens files by their names.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// io.open, io.lines, io.input, io.output, loadfile and dofile: names are resolved as everywhere in
// Hackle, by Session::input_path and output_path, which refuse what a script may not reach. What a
// script that is only looked at writes goes nowhere.
void open_files(lua_State* L);

}  // namespace hackle
