// SPDX-License-Identifier: MIT
// The texts around a plate and on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/theme.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A labelled point of the plate.
struct Marker {
  Vec2 place{0, 0};  // m
  std::string label;
};

// The user's choices.
struct OverlayOptions {
  std::optional<std::string> title;  // default: the material; "" for none
  bool clock = true;
  bool bar = true;
  bool scale_bar = true;
  bool load_curve = false;
  bool energy = false;
  std::vector<Marker> markers;
};

// A colour bar. Values beyond its ends have the colour of the end.
struct BarText {
  std::string label = "damage";
  double least = 0.0, most = 1.0;  // at its ends, in the unit of the label
  bool logarithmic = false;
};

// All texts of a picture, the same for a whole series. Any text may be empty.
struct OverlayText {
  OverlayOptions parts;  // except the title
  std::string title;
  std::string note;                      // describes the view: "deformed × 100"
  double slow_motion = 0.0;              // slow-motion factor; 0: not shown
  std::vector<BarText> bars{BarText{}};  // one per field
  Background background = Background::dark;
};

// Returns "slowed 133 000 times", to three digits; "" for 0.
std::string slow_motion_text(double factor);

// Returns "22.50 µs", always with the same number of decimals, so that it does not jump.
std::string time_text(double time);

// Returns a unit as pictures write it: "µs" for "us", "J/m³" for "J/m3".
std::string printed_unit(const std::string& name);

}  // namespace hackle
