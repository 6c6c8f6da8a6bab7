// SPDX-License-Identifier: MIT
// Options of a function of the scene language as words of a command: field=stress_1 range=0:12MPa.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "console/schema/schema.hpp"

namespace hackle {

class Console;

using WordOptions = std::vector<std::pair<std::string, std::string>>;

// Returns whether a word is an option, and not the name of a file.
bool is_option(const std::string& word);
// Returns its name and its value.
std::pair<std::string, std::string> option_in(const std::string& word);

// Returns the text as a Lua literal, whatever it contains.
std::string quoted(const std::string& text);

// Returns the function that the language knows under this name.
const FunctionDoc& doc_of(std::string_view owner, std::string_view name);

// Returns them as members of a table, ", field = \"stress_1\"". Throws Error (refused), in the name
// of `command`, with the nearest name, for one that the function does not have.
std::string lua_text(std::string_view command, const WordOptions& options, const FunctionDoc& doc);

// Checks each value separately, so that a message can name it. Throws Error (usage).
void check_values(Console& console, std::string_view command, const WordOptions& options,
                  const FunctionDoc& doc);

}  // namespace hackle
