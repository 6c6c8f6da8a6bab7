// SPDX-License-Identifier: MIT
// Describes values of a script for messages.
#pragma once

#include <string>
#include <string_view>

#include "console/lua/lua_state.hpp"

namespace hackle {

// [-0, +0] Describes the value at `index`: "the text 'abc'", "3.5", "a table", "nothing".
std::string description(lua_State* L, int index);

// Returns the beginning of a text, which may be long, in quotes.
std::string in_quotes(std::string_view text);
// Returns "nan" or the shortest text that reads back as the same number.
std::string number_text(double value);

// [-0, +0] Returns a text; the value must be one.
std::string_view text_at(lua_State* L, int index);

}  // namespace hackle
