// SPDX-License-Identifier: MIT
// Lua's own library, as far as a script from a stranger may have it.
#pragma once

#include "console/lua/lua_state.hpp"

namespace hackle {

// Opens it in a state that has a session. With the session's `trust` it is Lua's, whole; else a
// list of functions, from which are missing
//   os.execute, io.popen             other programs
//   os.remove, rename, tmpname       files outside of the folders of the Sandbox
//   os.getenv, setlocale             the user's secrets, the process
//   package.loadlib, cpath           machine code
//   string.dump                      byte code, which can crash Lua; load and its like take text
//   only debug, but for traceback         what the functions themselves rely on warn, io.tmpfile no
//   use here
// and setmetatable refuses __gc: no hook, and so no Ctrl-C, reaches a finalizer. In both cases
// files are found as file_binding.hpp says, and a script does the same in every process: tables are
// visited in one order (key_order.hpp), equal elements stay in theirs (table_sort.hpp), objects are
// named by numbers (object_name.hpp), and math.random begins with the same number every time, after
// math.randomseed() too. Left open are the clock and the date, the files it reads, the length of a
// list with gaps, the bytes that collectgarbage counts, and when weak tables lose their entries.
void open_standard_library(lua_State* L);

}  // namespace hackle
