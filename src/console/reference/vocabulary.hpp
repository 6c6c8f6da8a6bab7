// SPDX-License-Identifier: MIT
// All types and functions of the scene language.
#pragma once

#include <string_view>
#include <vector>

#include "console/schema/schema.hpp"

namespace hackle {

// All types, and all global functions in the order in which a script needs them.
std::vector<const TypeDoc*> all_types();
std::vector<Function> all_functions();
// Returns all functions and all methods.
std::vector<const FunctionDoc*> all_docs();
// Returns the type of this name, or null.
const TypeDoc* find_type(std::string_view name);

}  // namespace hackle
