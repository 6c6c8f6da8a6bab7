// SPDX-License-Identifier: MIT
// The options for a shape, shared by several functions: a circle, an ellipse, a polygon, a slot or
// a star.
#pragma once

#include <any>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "console/schema/arguments.hpp"
#include "scene/shape.hpp"
#include "scene/star.hpp"

namespace hackle {

// Reads the points of a polygon. Those of a file may begin and end with the same point, and must
// not cross themselves: they are then in no order around it.
std::any read_corners(const GivenValue& given);

// The unit of points, for all functions that take some.
inline constexpr std::array point_unit_options{
    Option{.name = "unit",
           .unit = "m",
           .range = above(0.0),
           .fallback = "1",
           .sentence = "Unit of the points: with unit = mm they are numbers of millimetres."},
};

inline constexpr std::array shape_options{
    Option{.name = "centre",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Centre of a circle, an ellipse, a regular polygon or a star."},
    Option{.name = "radius",
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Radius of a circle, or of the corners of a regular polygon or star."},
    Option{.name = "radii",
           .type = OptionType::pair,
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Half axes of an ellipse, {a, b}."},
    Option{
        .name = "angle",
        .unit = "rad",
        .fallback = "0",
        .sentence =
            "Angle of the first half axis or corner from x, anticlockwise; 30*deg is 30 degrees."},
    Option{.name = "corners",
           .type = OptionType::integer,
           .range = between(3, max_corners),
           .alternative = true,
           .sentence = "Number of corners of a regular polygon, or of tips of a star."},
    Option{
        .name = "inner",
        .unit = "m",
        .range = above(0.0),
        .alternative = true,
        .sentence = "Radius of the corners between the tips of a star, or of the hole of a ring."},
    Option{.name = "points",
           .type = OptionType::points,
           .read = read_corners,
           .unit = "m",
           .range = between(3, max_points),
           .alternative = true,
           .sentence =
               "Corners of a polygon, or a CSV file of x, y; parts where it overlaps itself "
               "count as outside."},
    point_unit_options[0],
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Beginning of the middle line of a slot with round ends."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "End of the middle line of the slot."},
    Option{.name = "width",
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Radius of the slot: half its width."},
};

// One way to describe a thing: the options it needs, and optional further ones.
struct Form {
  std::span<const std::string_view> needed;
  std::span<const std::string_view> allowed{};
};

// Returns which form the given options make. If they make none, adds a problem that names all
// forms; returns nothing then, and also if some of their options were wrong. `what` is "the shape".
std::optional<std::size_t> form_of(Arguments& arguments, std::span<const Form> forms,
                                   std::string_view who, std::string_view what);

// Reads a std::vector<Shape>: one area, given by the options above, or a list of such.
std::any read_areas(const GivenValue& given);

// Returns the shape given by the arguments of a function with shape_options. Adds a problem and
// returns nothing if they do not make one.
std::optional<Shape> shape_of(Arguments& arguments, std::string_view who);

}  // namespace hackle
