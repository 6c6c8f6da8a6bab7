// SPDX-License-Identifier: MIT
// The texts of help() about everything in the scene language.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "console/schema/schema.hpp"

namespace hackle {

// The width of terminal for which texts are laid out.
inline constexpr std::size_t reference_width = 80;

// Returns the name of an object of the type in examples: "p".
std::string_view object_name(const TypeDoc& type);

// Lists functions and methods with a sentence each.
std::string list_of_functions();
// Lists the unit constants by dimension.
std::string list_of_units();
// Lists the fields of pictures with a sentence each.
std::string list_of_fields();
std::string list_of_columns();  // of tables
std::string list_of_charts();

// Returns signature, sentence, table of options, example and related functions.
std::string reference_of(const FunctionDoc& doc);
// Returns methods and fields.
std::string reference_of(const TypeDoc& type);
// Explains a function, a method, a type, a field, an option, a unit or a list; throws Error
// (refused) with the nearest name.
std::string reference_of(std::string_view name);
// Returns every name that it knows, sorted, without duplicates.
std::vector<std::string> topics();

}  // namespace hackle
