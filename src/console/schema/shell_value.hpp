// SPDX-License-Identifier: MIT
// Values as they are written on a command line, where * and braces mean something to the shell:
// 24MPa, 0.5mm, 0:12MPa, 10us,20us.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace hackle {

// Exponents of mass, length, time and angle.
using Dimension = std::array<int, 4>;
inline constexpr Dimension no_dimension{};

// Returns the value as an expression of Lua: "24MPa" is "24*MPa"; "0:12MPa" and "0,12MPa" are
// "{0*MPa, 12*MPa}", where a number without a unit has that of the last. Everything else stays.
std::string shell_expression(std::string_view value);

// Returns the dimension of a product or quotient of numbers and unit constants, as in 2*N/mm;
// nothing for any other expression.
std::optional<Dimension> dimension_of(std::string_view expression);

// Returns "stress" for the dimension of Pa; "m2 kg/s" and the like for one without a name.
std::string dimension_name(const Dimension& dimension);

// Returns the expression given for `name` in the braces of the first call options { ... } of a
// script; empty if there is none.
std::string option_expression(std::string_view script, std::string_view name);

}  // namespace hackle
