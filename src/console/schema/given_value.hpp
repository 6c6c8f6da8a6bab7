// SPDX-License-Identifier: MIT
// The unchecked value that a script gave for one option of a call.
#pragma once

#include <any>
#include <cstddef>
#include <string>

#include "base/error.hpp"
#include "console/schema/schema.hpp"

namespace hackle {

// Lives while the call is being checked. Tables are read with raw access only, so that no
// metamethod of a script runs during a check.
struct GivenValue {
  lua_State* L;
  int index;  // on the stack
  const FunctionDoc& doc;
  const Option& option;
  Problems& problems;  // of the call

  // Returns "traction: stress".
  std::string name() const;
  // Returns whether it is a list with a length in the option's range; adds a problem if not.
  bool is_list() const;
  // Each adds a problem and returns nothing, for a reader to return.
  std::any wrong(std::string what, std::string remedy = {}) const;
  std::any wrong_type() const;
};

// [-0, +0] Returns the number of entries of a table, under keys of any kind.
std::size_t entries(lua_State* L, int index);

}  // namespace hackle
