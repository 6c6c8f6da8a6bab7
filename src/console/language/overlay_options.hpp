// SPDX-License-Identifier: MIT
// What stands around a plate and on it, as every picture takes it.
#pragma once

#include "console/schema/arguments.hpp"
#include "render/overlay_text.hpp"

namespace hackle {

// A list of Marker: {x, y, "label"}.
std::any read_markers(const GivenValue& given);

inline constexpr std::array overlay_options{
    Option{.name = "title",
           .type = OptionType::caption,
           .fallback = "the material",
           .sentence = "Above the plate; \"\" for none."},
    Option{.name = "clock",
           .type = OptionType::flag,
           .fallback = "true",
           .sentence = "The time stands above the plate, in a movie how much it is slowed, too."},
    Option{.name = "bar",
           .type = OptionType::flag,
           .fallback = "true",
           .sentence = "The colour bar stands below the plate, with name, unit and range."},
    Option{.name = "scale_bar",
           .type = OptionType::flag,
           .fallback = "true",
           .sentence = "A line of a neat length stands below the plate."},
    Option{.name = "load_curve",
           .type = OptionType::flag,
           .fallback = "false",
           .sentence = "The loads over time, with the present moment; in a picture those of now."},
    Option{.name = "energy",
           .type = OptionType::flag,
           .fallback = "false",
           .sentence = "Kinetic, strain and broken energy over time so far; for movies."},
    Option{.name = "markers",
           .type = OptionType::markers,
           .read = read_markers,
           .unit = "m",
           .range = at_least(1.0),
           .fallback = "none",
           .sentence = "Points of the plate with their labels, {x, y, \"tip\"}; those that find no "
                       "room are left out."},
};

OverlayOptions overlay_of(const Arguments& arguments);

}  // namespace hackle
