// SPDX-License-Identifier: MIT
// What a picture shows and how large it is, as several functions take it.
#pragma once

#include "console/arguments.hpp"
#include "output/run.hpp"

namespace hackle {

inline constexpr Option field_option{.name = "field",
                                     .type = OptionType::choice,
                                     .fallback = "damage",
                                     .choices = field_names,
                                     .sentence = "What is painted."};
inline constexpr Option zoom_option{.name = "zoom",
                                    .type = OptionType::window,
                                    .unit = "m",
                                    .range = above(0.0),
                                    .fallback = "the plate",
                                    .sentence =
                                        "Middle and half the width of what is seen; it has "
                                        "the shape of the plate."};
inline constexpr Option width_option{.name = "width",
                                     .type = OptionType::integer,
                                     .unit = "px",
                                     .range = between(320.0, 7680.0),
                                     .fallback = "1280",
                                     .sentence = "Of the picture, even."};

// Field and zoom, of a function that takes both.
PictureOptions picture_of(const Arguments& arguments);

// The width too.
PictureOptions sized_picture_of(const Arguments& arguments);

}  // namespace hackle
