// SPDX-License-Identifier: MIT
// An option as shown by help() and the reference pages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "console/schema/schema.hpp"

namespace hackle {

struct OptionRow {
  std::string name;
  std::string type;      // "number", "{x, y}"
  std::string values;    // "above 0 m", "dark, light", or ""
  std::string presence;  // "required", "one way", "default 4"
  std::string sentence;
  bool operator==(const OptionRow&) const = default;
};

OptionRow row_of(const Option& option);

// Formats the rows as an aligned table, with the sentences beside or, if that exceeds `width`
// columns, below. Lines end in "
// ".
std::string table_text(const std::vector<OptionRow>& rows, std::size_t width);

}  // namespace hackle
