// SPDX-License-Identifier: MIT
// Reads C++ sources well enough to tell what they declare at namespace scope.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hackle {

// Something declared at namespace scope.
struct Declaration {
  std::string name;
  bool is_function = false;   // else a constant or variable
  bool is_anonymous = false;  // in an anonymous namespace
  std::string parameters;     // types of those of a function, without names
};

// Returns the constants, variables and functions that a source declares at namespace scope, in
// order; types, members and operators are left out.
std::vector<Declaration> declarations_of(std::string_view source);

}  // namespace hackle
