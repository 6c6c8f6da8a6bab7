// SPDX-License-Identifier: MIT
// The options for a region, shared by several functions: a strip along an edge, a rectangle or a
// disc.
#pragma once

#include <array>
#include <string_view>

#include "console/schema/arguments.hpp"
#include "scene/plate.hpp"

namespace hackle {

inline constexpr std::array region_options{
    Option{.name = "edge",
           .type = OptionType::choice,
           .choices = enum_names<Edge>,
           .alternative = true,
           .sentence = "Edge of a strip, with depth."},
    Option{.name = "depth",
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Depth of the strip into the plate; one horizon is usual."},
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
           .sentence = "Centre of a disc, instead of a rectangle or strip."},
    Option{.name = "radius",
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Radius of the disc."},
};

// Returns the region given by the arguments of a function with region_options; nothing if none of
// them is given. Adds a problem if they mix the forms or give only half of one.
Region region_of(Arguments& arguments, const Plate& plate, std::string_view who);

}  // namespace hackle
