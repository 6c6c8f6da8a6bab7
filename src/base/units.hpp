// SPDX-License-Identifier: MIT
// Units: everything inside is SI; these constants and texts are for the world outside.
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

// Every unit constant of the scene language.
std::span<const Unit> units();

// A number with its unit as a person writes it: quantity(5e-4, "m") is "0.5 mm". Four significant
// digits. Units "m", "s", "Pa", "J", "J/m3", "B" (bytes) and "m/s" take a prefix; all others are
// printed as they are, and "" prints the bare number.
std::string quantity(double value, std::string_view unit);

// The unit with the prefix that suits numbers of this size, and what it is in SI: {"MPa", 1e6}.
struct PrefixedUnit {
  std::string name;
  double factor = 1.0;
};
PrefixedUnit prefixed(double size, std::string_view unit);

// A count with thin groups of three: grouped(16000) is "16 000".
std::string grouped(long long count);

// The shortest text that reads back as the same number.
std::string shortest(double value);

}  // namespace hackle
