// SPDX-License-Identifier: MIT
#pragma once

#include "base/described.hpp"

namespace hackle {

// An edge of a rectangular plate.
enum class Edge { left, right, bottom, top };

template <>
inline constexpr auto enum_names<Edge> = std::to_array<std::string_view>({"left", "right", "bottom",
                                                                          "top"});

}  // namespace hackle
