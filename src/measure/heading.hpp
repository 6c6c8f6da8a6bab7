// SPDX-License-Identifier: MIT
// The names of columns in files: "tip.x" in m is "tip_x_m", an identifier in every program that
// reads tables, and the same as a key of --json.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hackle {

// Returns the heading of a column with this name and unit; "" is no unit.
std::string heading_of(std::string_view name, std::string_view unit);

// Returns the unit, "" for none, of a heading that is of this column, with . or _ in its name; else
// nothing. Also takes the whole heading as the name.
std::optional<std::string> unit_in_heading(std::string_view heading, std::string_view name);

// Returns the name without its unit, "tip_x".
std::string name_in_heading(std::string_view heading);

}  // namespace hackle
