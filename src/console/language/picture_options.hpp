// SPDX-License-Identifier: MIT
// The options for content and size of a picture, shared by several functions.
#pragma once

#include "console/language/overlay_options.hpp"
#include "console/schema/arguments.hpp"
#include "output/run.hpp"
#include "render/colour_map.hpp"

namespace hackle {

inline constexpr std::array<std::string_view, 2> scale_names{"linear", "log"};
// The default where each field has its own.
inline constexpr std::string_view suits_the_field = "depends on the field";

inline constexpr std::string_view not_chosen = "none";

// Returns the choices of an option that may be empty.
template <std::size_t N>
constexpr std::array<std::string_view, N + 1> or_none(
    const std::array<std::string_view, N>& names) {
  std::array<std::string_view, N + 1> all{not_chosen};
  std::ranges::copy(names, all.begin() + 1);
  return all;
}
inline constexpr auto second_names = or_none(scalar_names);
inline constexpr auto follow_names = or_none(toward_names);

// The visible part of the plate and its appearance.
inline constexpr std::array view_options{
    Option{.name = "field",
           .type = OptionType::choice,
           .fallback = "damage",
           .choices = scalar_names,
           .sentence = "Field to paint."},
    Option{.name = "range",
           .type = OptionType::pair,
           .fallback = suits_the_field,
           .sentence = "Values at the two ends of the colour bar, in SI units."},
    Option{.name = "percentile",
           .range = between(50.0, 100.0),
           .alternative = true,
           .sentence = "Instead of a range: the colour bar spans this share of the values, in %."},
    Option{.name = "scale",
           .type = OptionType::choice,
           .fallback = suits_the_field,
           .choices = scale_names,
           .sentence = "Scale of the colour bar."},
    Option{.name = "colours",
           .type = OptionType::choice,
           .fallback = suits_the_field,
           .choices = colour_map_names,
           .sentence = "Colour map of the colour bar."},
    Option{.name = "second",
           .type = OptionType::choice,
           .fallback = not_chosen,
           .choices = second_names,
           .sentence = "A second field in the same picture."},
    Option{.name = "arrange",
           .type = OptionType::choice,
           .fallback = "below",
           .choices = arrangement_names,
           .sentence = "Place of the second field: below or right of the midline, over the first, "
                       "or beside it."},
    Option{.name = "second_range",
           .type = OptionType::pair,
           .fallback = suits_the_field,
           .sentence = "Range of the second field."},
    Option{.name = "cracks",
           .type = OptionType::flag,
           .fallback = "true",
           .sentence = "Shows cracks as gaps, except in a picture of damage."},
    Option{.name = "thickness",
           .unit = "m",
           .range = above(0.0),
           .fallback = "0.005",
           .sentence = "Thickness of the plate, for a picture of fringes."},
    Option{
        .name = "zoom",
        .type = OptionType::window,
        .unit = "m",
        .range = above(0.0),
        .fallback = "the plate",
        .sentence = "Centre and half width of the visible part, which has the shape of the plate."},
    Option{.name = "follow",
           .type = OptionType::choice,
           .fallback = not_chosen,
           .choices = follow_names,
           .sentence = "Makes the zoom follow the foremost damage in this direction."},
    Option{.name = "rotate",
           .unit = "rad",
           .range = between(-6.3, 6.3),
           .fallback = "0",
           .sentence = "Turns the picture anticlockwise; 90*deg puts the plate on end."},
    Option{.name = "deformed",
           .type = OptionType::flag,
           .fallback = "false",
           .sentence = "Shows the deformed plate, with displacements magnified."},
    Option{.name = "magnify",
           .range = between(0.0, 1e9),
           .fallback = "depends on the plate",
           .sentence = "Magnification of displacements in a deformed plate."},
    Option{.name = "bonds",
           .type = OptionType::flag,
           .fallback = "false",
           .sentence = "Draws every visible bond, for a zoom on a few nodes."},
    Option{.name = "background",
           .type = OptionType::choice,
           .fallback = "dark",
           .choices = background_names,
           .sentence = "Background around the plate; transparent only in a PNG."},
};
// The options of every picture.
inline constexpr auto picture_options = joined(view_options, overlay_options);
inline constexpr Option width_option{.name = "width",
                                     .type = OptionType::integer,
                                     .unit = "px",
                                     .range = between(320.0, 7680.0),
                                     .fallback = "1280",
                                     .sentence = "Width of the picture, even."};
inline constexpr Option scale_option{.name = "px_per_mm",
                                     .range = above(0.0),
                                     .alternative = true,
                                     .sentence = "Instead of the width: px per mm."};
// Reads all options except the width.
PictureOptions picture_of(const Arguments& arguments);

// Reads all options, including the width.
PictureOptions sized_picture_of(const Arguments& arguments);

}  // namespace hackle
