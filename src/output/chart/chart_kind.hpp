// SPDX-License-Identifier: MIT
// The charts that have a name.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hackle {

struct ChartKind {
  std::string_view name;                        // "energy"
  std::string_view title;                       // of the y axis too
  std::span<const std::string_view> columns{};  // those of them that there are are drawn
  std::string_view sentence;                    // for help
};

// The table of them. "load" takes its columns from the names of loads, "histogram" from a field.
std::span<const ChartKind> chart_kinds();
const ChartKind* chart_kind(std::string_view name);

}  // namespace hackle
