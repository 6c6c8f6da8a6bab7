// SPDX-License-Identifier: MIT
// Values of Lua as bytes of a journal, the same in every process.
#pragma once

#include <functional>
#include <string>

#include "console/lua/lua_state.hpp"
#include "console/replay/journal.hpp"

namespace hackle {

// Names the objects that a script may hold: a simulation by its number.
using NameObject = std::function<std::string(lua_State* L, int index)>;

// [-0, +0] Returns the values at `first` to `last` as text for comparison: of numbers every bit,
// tables with all that they hold, objects by name, functions without their content.
std::string texts_of(lua_State* L, int first, int last, const NameObject& name);

// [-0, +0] Writes the values, which must be nil, booleans, numbers, text and tables of such.
// Returns whether they are; if not, nothing has been written.
bool write_values(lua_State* L, int first, int last, JournalWriter& journal);

// [-0, +n] Pushes values that were written, and returns their number. Throws JournalMismatch.
int push_values(lua_State* L, JournalReader& journal);

}  // namespace hackle
