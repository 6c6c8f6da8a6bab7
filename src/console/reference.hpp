// SPDX-License-Identifier: MIT
// Everything the scene language knows, and what help() tells about it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "console/schema.hpp"

namespace hackle {

// Texts are laid out for a terminal this wide.
inline constexpr std::size_t reference_width = 80;

// Every type, and every global function in the order in which a script needs them.
std::vector<const TypeDoc*> all_types();
std::vector<Function> all_functions();
// All functions and all methods.
std::vector<const FunctionDoc*> all_docs();
// The type of this name, or null.
const TypeDoc* find_type(std::string_view name);

// "plate", "p:crack"
std::string call_name(const FunctionDoc& doc);

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
