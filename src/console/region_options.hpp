// SPDX-License-Identifier: MIT
// Where something acts, as several functions take it: a strip along an edge, a rectangle or a disc.
#pragma once

#include <array>
#include <string_view>

#include "console/arguments.hpp"
#include "scene/plate.hpp"

namespace hackle {

// In the order of the enumerators.
inline constexpr std::array<std::string_view, 4> edge_names{"left", "right", "bottom", "top"};

inline constexpr std::array region_options{
    Option{.name = "edge",
           .type = OptionType::choice,
           .choices = edge_names,
           .alternative = true,
           .sentence = "The edge of a strip, with depth."},
    Option{.name = "depth",
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "How far the strip reaches into the plate; one horizon is usual."},
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Lower left corner of a rectangle, instead of edge and depth."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Upper right corner of the rectangle."},
    Option{.name = "centre",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Middle of a disc, instead."},
    Option{.name = "radius",
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Of the disc."},
};

// Two tables of options as one.
template <std::size_t n, std::size_t m>
constexpr std::array<Option, n + m> joined(const std::array<Option, n>& one,
                                           const std::array<Option, m>& other) {
  std::array<Option, n + m> all{};
  for (std::size_t k = 0; k < n; ++k) all[k] = one[k];
  for (std::size_t k = 0; k < m; ++k) all[n + k] = other[k];
  return all;
}

// What the arguments of a function with region_options say; nothing when they give none of them.
// Adds a problem when they mix the ways or give half of one.
Region region_of(Arguments& arguments, const Plate& plate, std::string_view who);

}  // namespace hackle
