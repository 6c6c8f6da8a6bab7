// SPDX-License-Identifier: MIT
// What a script gave, in the words of a message.
#pragma once

#include <string>
#include <string_view>

#include "console/lua/lua_state.hpp"

namespace hackle {

// [-0, +0] What is at `index`: "the text 'abc'", "3.5", "a table", "nothing".
std::string description(lua_State* L, int index);

// The first of a text, which may be long.
std::string in_quotes(std::string_view text);
// "nan" or the shortest text that gives the same number.
std::string number_text(double value);

// [-0, +0] Of what is a text.
std::string_view text_at(lua_State* L, int index);

}  // namespace hackle
