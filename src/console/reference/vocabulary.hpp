// SPDX-License-Identifier: MIT
// Everything the scene language knows.
#pragma once

#include <string_view>
#include <vector>

#include "console/schema/schema.hpp"

namespace hackle {

// Every type, and every global function in the order in which a script needs them.
std::vector<const TypeDoc*> all_types();
std::vector<Function> all_functions();
// All functions and all methods.
std::vector<const FunctionDoc*> all_docs();
// The type of this name, or null.
const TypeDoc* find_type(std::string_view name);

}  // namespace hackle
