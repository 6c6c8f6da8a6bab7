// SPDX-License-Identifier: MIT
// An option as help() and the reference pages show it.
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

// The rows as an aligned table, a sentence beside each or, when that is too wide for a terminal of
// so many columns, below. Lines end in "\n".
std::string table_text(const std::vector<OptionRow>& rows, std::size_t width);

}  // namespace hackle
