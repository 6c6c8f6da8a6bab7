// SPDX-License-Identifier: MIT
// Units: all internal values are SI; these constants and texts are for input and output.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hackle {

// A named unit and its size in SI, e.g. {"mm", 1e-3, "length"}.
struct Unit {
  std::string_view name;
  double factor;
  std::string_view dimension;
};

// Returns every unit constant of the scene language.
std::span<const Unit> units();

// Returns a number with its unit in customary form: quantity(5e-4, "m") is "0.5 mm". Four
// significant digits. Units "m", "s", "Pa", "J", "J/m3", "N", "B" (bytes) and "m/s" take a prefix;
// all others are printed unchanged, and "" prints the bare number.
std::string quantity(double value, std::string_view unit);

// A unit with the prefix that suits numbers of this size, and its size in SI: {"MPa", 1e6}.
struct PrefixedUnit {
  std::string name;
  double factor = 1.0;
};
PrefixedUnit prefixed(double size, std::string_view unit);

// Returns a count with its digits in groups of three: grouped(16000) is "16 000".
std::string grouped(long long count);

// Returns the shortest text that reads back as the same number.
std::string shortest(double value);

}  // namespace hackle
