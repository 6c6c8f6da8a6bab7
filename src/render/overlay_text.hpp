// SPDX-License-Identifier: MIT
// What is said around a plate and on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/theme.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// A point of the plate with a name.
struct Marker {
  Vec2 place{0, 0};  // m
  std::string label;
};

// What a user asks for.
struct OverlayOptions {
  std::optional<std::string> title;  // the material if not given; "" for none
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

// All that a picture says, the same for a series of them. Any text may be empty.
struct OverlayText {
  OverlayOptions parts;  // but for the title
  std::string title;
  std::string note;                      // how the plate is shown, "deformed × 100"
  double slow_motion = 0.0;              // how many times slower than it is; 0: not said
  std::vector<BarText> bars{BarText{}};  // one for each field
  Background background = Background::dark;
};

// "slowed 133 000 times", three digits of it; "" for 0.
std::string slow_motion_text(double factor);

// "22.50 µs"; always as many decimals, so that it does not dance.
std::string time_text(double time);

// A unit as pictures write it: "µs" for "us", "J/m³" for "J/m3".
std::string printed_unit(const std::string& name);

}  // namespace hackle
