// SPDX-License-Identifier: MIT
// An expectation as a script gives it: its numbers may be functions, which are called when the
// script has ended.
#pragma once

#include <any>
#include <string>
#include <variant>
#include <vector>

#include "console/lua/lua_function.hpp"
#include "console/schema/given_value.hpp"
#include "output/report/expectation.hpp"

namespace hackle {

// What was given for a number or a curve; nothing if there was nothing.
using Reading = std::variant<std::monostate, double, std::vector<double>, LuaFunction>;

// Reads a number, a list of numbers or a function. Numbers need not be finite: one that is not is a
// quantity that was not found.
std::any read_reading(const GivenValue& given);

struct ScriptedExpectation {
  Expectation known;  // without what the readings give
  Reading value, got;

  // Calls the functions and returns the whole. A function that fails, or returns no finite number,
  // makes a failed expectation with the message as its reason. Throws Error (interrupted).
  Expectation settled() const;
};

}  // namespace hackle
