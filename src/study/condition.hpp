// SPDX-License-Identifier: MIT
// A condition on a quantity of a run: "branches >= 2", "fork.time < 20us".
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/described.hpp"
#include "study/quantity.hpp"

namespace hackle {

enum class Comparison { less, at_most, greater, at_least, equal };
template <>
inline constexpr auto enum_names<Comparison> = std::to_array<std::string_view>({"<", "<=", ">",
                                                                                ">=", "=="});

struct Condition {
  QuantityRow row;  // a number or a count
  Comparison comparison = Comparison::less;
  double value = 0.0;  // in the unit of the row
  std::string text;    // as written

  // A quantity that a run did not find fulfils no condition.
  bool holds(const Outcome& outcome) const;
};

// Reads NAME (<|<=|>|>=|==) NUMBER[unit]. Throws Error (usage), with the nearest name for a
// quantity that there is not.
Condition condition_of(std::string_view text);

}  // namespace hackle
