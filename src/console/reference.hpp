// SPDX-License-Identifier: MIT
// Everything the scene language knows, and its reference text.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "console/schema.hpp"

namespace hackle {

// Every type, and every global function in the order in which a script needs them.
std::vector<const TypeDoc*> all_types();
std::vector<Function> all_functions();

// Functions and types, a line each.
std::string overview();
// Signature, sentence, table of options, example; for a function that makes a type, its methods
// too.
std::string reference_of(const FunctionDoc& doc);
// Methods and fields.
std::string reference_of(const TypeDoc& type);
// Of a global function, a method or a type; throws Error (refused) with the nearest name.
std::string reference_of(std::string_view name);

}  // namespace hackle
