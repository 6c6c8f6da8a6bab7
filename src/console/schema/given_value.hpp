// SPDX-License-Identifier: MIT
// What a script gave for one option of a call, before it is known to be right.
#pragma once

#include <any>
#include <cstddef>
#include <string>

#include "base/error.hpp"
#include "console/schema/schema.hpp"

namespace hackle {

// Lives as long as the call is checked. Tables are read with raw access only: no metamethod of a
// script runs in the middle of a check.
struct GivenValue {
  lua_State* L;
  int index;  // on the stack
  const FunctionDoc& doc;
  const Option& option;
  Problems& problems;  // of the call

  // "traction: stress"
  std::string name() const;
  // Whether it is a list as long as the option says; adds a problem if not.
  bool is_list() const;
  // Each adds a problem and returns nothing, which a reader returns.
  std::any wrong(std::string what, std::string remedy = {}) const;
  std::any wrong_type() const;
};

// [-0, +0] Of a table, under keys of any kind.
std::size_t entries(lua_State* L, int index);

}  // namespace hackle
