// SPDX-License-Identifier: MIT
// What a picture shows and how large it is, as several functions take it.
#pragma once

#include "console/arguments.hpp"
#include "output/run.hpp"
#include "render/colour_map.hpp"

namespace hackle {

inline constexpr std::array<std::string_view, 2> scale_names{"linear", "log"};
// The default of what each field has for itself.
inline constexpr std::string_view suits_the_field = "what suits the field";

// What every picture takes.
inline constexpr std::array picture_options{
    Option{.name = "field",
           .type = OptionType::choice,
           .fallback = "damage",
           .choices = scalar_names,
           .sentence = "What is painted."},
    Option{.name = "range",
           .type = OptionType::pair,
           .fallback = suits_the_field,
           .sentence = "Values at the two ends of the colour bar, in SI units."},
    Option{.name = "percentile",
           .range = between(50.0, 100.0),
           .alternative = true,
           .sentence = "Instead of a range: it spans this share of the values, in %."},
    Option{.name = "scale",
           .type = OptionType::choice,
           .fallback = suits_the_field,
           .choices = scale_names,
           .sentence = "Of the colour bar."},
    Option{.name = "colours",
           .type = OptionType::choice,
           .fallback = suits_the_field,
           .choices = colour_map_names,
           .sentence = "Of the colour bar."},
    Option{.name = "cracks",
           .type = OptionType::flag,
           .fallback = "true",
           .sentence = "Cracks are gaps, except in a picture of damage."},
    Option{.name = "thickness",
           .unit = "m",
           .range = above(0.0),
           .fallback = "0.005",
           .sentence = "Of the plate, for a picture of fringes."},
    Option{.name = "zoom",
           .type = OptionType::window,
           .unit = "m",
           .range = above(0.0),
           .fallback = "the plate",
           .sentence = "Middle and half the width of what is seen; it has the shape of the plate."},
};
inline constexpr Option width_option{.name = "width",
                                     .type = OptionType::integer,
                                     .unit = "px",
                                     .range = between(320.0, 7680.0),
                                     .fallback = "1280",
                                     .sentence = "Of the picture, even."};

// All but the width.
PictureOptions picture_of(const Arguments& arguments);

// The width too.
PictureOptions sized_picture_of(const Arguments& arguments);

}  // namespace hackle
