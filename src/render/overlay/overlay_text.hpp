// SPDX-License-Identifier: MIT
// The texts around a plate and on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/described.hpp"
#include "render/theme.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A labelled point of the plate.
struct Marker {
  Vec2 place{0, 0};  // m
  std::string label;
};

template <>
inline constexpr auto description_of<Marker> = describe_noun("marker", "marker",
                                                             member("place", &Marker::place,
                                                                    {.unit = "m"}),
                                                             member("label", &Marker::label));

// The user's choices.
struct OverlayOptions {
  std::optional<std::string> title;  // default: the material; "" for none
  bool clock = true;
  bool bar = true;
  bool scale_bar = true;
  bool axes = false;
  bool load_curve = false;
  bool energy = false;
  bool graph = false;
  std::vector<Marker> markers;
};

template <>
inline constexpr auto description_of<OverlayOptions> = describe_noun(
    "overlay", "overlay",
    member("title", &OverlayOptions::title,
           {.fallback = "the material", .sentence = "Title above the plate; \"\" for none."}),
    member("clock", &OverlayOptions::clock,
           {.fallback = "true",
            .sentence = "Shows the time above the plate; in a movie also the slow-motion factor."}),
    member("bar", &OverlayOptions::bar,
           {.fallback = "true",
            .sentence = "Shows a colour bar below the plate, with name, unit and range."}),
    member("scale_bar", &OverlayOptions::scale_bar,
           {.fallback = "true",
            .sentence = "Shows a scale bar of a round length below the plate."}),
    member("axes", &OverlayOptions::axes,
           {.fallback = "false",
            .sentence = "Shows coordinates in mm along the plate's left and lower side."}),
    member(
        "load_curve", &OverlayOptions::load_curve,
        {.fallback = "false",
         .sentence = "Shows the loads over time, marking the present; of a function of time, in a "
                     "picture, the present value."}),
    member("energy", &OverlayOptions::energy,
           {.fallback = "false",
            .sentence = "Shows kinetic, strain and broken energy over time so far; for movies."}),
    member("graph", &OverlayOptions::graph,
           {.fallback = "false",
            .sentence = "Draws the paths of cracks and their tips, in a picture or movie of a run "
                        "with their speed (see s:graph); not in a deformed plate."}),
    member("markers", &OverlayOptions::markers,
           {.unit = "m",
            .range = at_least(1.0),
            .fallback = "none",
            .sentence = "Points of the plate with labels, {x, y, \"tip\"}; labels without room are "
                        "left out."}));

// A colour bar. Values beyond its ends have the colour of the end.
struct BarText {
  std::string label = "damage";
  double min = 0.0, max = 1.0;  // at its ends, in the unit of the label
  bool logarithmic = false;
  bool whole = false;       // only whole numbers are written
  std::string remark = {};  // below the label; may be empty
};

// All texts of a picture, the same for a whole series. Any text may be empty.
struct OverlayText {
  OverlayOptions parts;  // except the title
  std::string title;
  std::string note;                      // describes the view: "deformed × 100"
  double slow_motion = 0.0;              // slow-motion factor; 0: not shown
  std::vector<BarText> bars{BarText{}};  // one per field
  Background background = Background::dark;
  double font = 0.0;  // px, of titles, time and names; 0: suits the width
};

// Returns "slowed 133 000 times", to three digits; "" for 0.
std::string slow_motion_text(double factor);

// Returns "22.50 µs", always with the same number of decimals, so that it does not jump.
std::string time_text(double time);

// Returns a unit as pictures write it: "µs" for "us", "J/m³" for "J/m3".
std::string printed_unit(const std::string& name);

}  // namespace hackle
