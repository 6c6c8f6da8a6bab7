// SPDX-License-Identifier: MIT
// Lua's standard library, as far as an untrusted script may have it.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Opens the library in a state that has a session. With the session's `trust` it is Lua's whole
// library; otherwise these functions are missing:
//   os.execute, io.popen             run other programs
//   os.remove, rename, tmpname       change files outside the folders of the Sandbox
//   os.getenv, setlocale             reach the user's secrets, the process
//   package.loadlib, cpath           load machine code
//   string.dump                      makes byte code, which can crash Lua; load and its like take
//                                    text only
//   debug, except traceback          reaches what the functions themselves rely on
//   warn, io.tmpfile                 have no use here
// and setmetatable refuses __gc: no hook, and so no Ctrl-C, reaches a finalizer.
// In both cases files are found as described in file_binding.hpp, and a script does the same in
// every process: tables are traversed in one order (key_order.hpp), equal elements keep their order
// (table_sort.hpp), objects are named by numbers (object_name.hpp), and math.random starts with the
// same number every time, also after math.randomseed(). Still variable are the clock and the date,
// the content of files, the length of a list with gaps, the bytes counted by collectgarbage, and
// the time at which weak tables lose their entries.
void open_standard_library(lua_State* L);

}  // namespace hackle
