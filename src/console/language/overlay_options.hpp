// SPDX-License-Identifier: MIT
// The options of every picture for texts and marks around and on the plate.
#pragma once

#include "console/schema/arguments.hpp"
#include "render/overlay_text.hpp"

namespace hackle {

// Reads a list of Marker: {x, y, "label"}.
std::any read_markers(const GivenValue& given);

inline constexpr std::array overlay_options{
    Option{.name = "title",
           .type = OptionType::caption,
           .fallback = "the material",
           .sentence = "Title above the plate; \"\" for none."},
    Option{.name = "clock",
           .type = OptionType::flag,
           .fallback = "true",
           .sentence = "Shows the time above the plate; in a movie also the slow-motion factor."},
    Option{.name = "bar",
           .type = OptionType::flag,
           .fallback = "true",
           .sentence = "Shows a colour bar below the plate, with name, unit and range."},
    Option{.name = "scale_bar",
           .type = OptionType::flag,
           .fallback = "true",
           .sentence = "Shows a scale bar of a round length below the plate."},
    Option{.name = "load_curve",
           .type = OptionType::flag,
           .fallback = "false",
           .sentence =
               "Shows the loads over time, marking the present; in a picture the present loads."},
    Option{.name = "energy",
           .type = OptionType::flag,
           .fallback = "false",
           .sentence = "Shows kinetic, strain and broken energy over time so far; for movies."},
    Option{
        .name = "markers",
        .type = OptionType::markers,
        .read = read_markers,
        .unit = "m",
        .range = at_least(1.0),
        .fallback = "none",
        .sentence =
            "Points of the plate with labels, {x, y, \"tip\"}; labels without room are left out."},
};

OverlayOptions overlay_of(const Arguments& arguments);

}  // namespace hackle
