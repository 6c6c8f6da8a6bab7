// SPDX-License-Identifier: MIT
// What help() tells about everything that the scene language knows.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "console/schema/schema.hpp"

namespace hackle {

// Texts are laid out for a terminal this wide.
inline constexpr std::size_t reference_width = 80;

// Functions and methods, a sentence each.
std::string list_of_functions();
// The unit constants by dimension.
std::string list_of_units();
// What pictures can show, a sentence each.
std::string list_of_fields();

// Signature, sentence, table of options, example, what else to read.
std::string reference_of(const FunctionDoc& doc);
// Methods and fields.
std::string reference_of(const TypeDoc& type);
// Of a function, a method, a type, a field, an option, a unit or a list; throws Error (refused)
// with the nearest name.
std::string reference_of(std::string_view name);
// Every name that it knows, each once, in order.
std::vector<std::string> topics();

}  // namespace hackle
