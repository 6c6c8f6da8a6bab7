// SPDX-License-Identifier: MIT
// What all pictures of a series have in common.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "lattice/grid.hpp"
#include "measure/scalar.hpp"
#include "render/layout.hpp"
#include "render/overlay_text.hpp"

namespace hackle {

// Where a second field is seen: in the lower or the right half of the plate, for scenes that are
// symmetric about the midline, over the first field, the more opaque the larger it is, or on a
// plate of its own.
enum class Arrangement { below, right, over, beside };
inline constexpr std::array<std::string_view, 4> arrangement_names{"below", "right", "over",
                                                                   "beside"};

// How a field is painted.
struct FieldStyle {
  std::string colour_map = "damage";  // one of colour_map_names, or fringes_name
  double least = 0.0;                 // the values at the two ends of the colour bar, in SI;
  double most = 0.5;                  // least < most, and above 0 if the scale is logarithmic
  bool logarithmic = false;
  Sampling sampling = Sampling::largest;
  std::string label = "damage";  // of the colour bar
  std::string unit;              // of the values, SI; may be empty
};

struct PictureStyle {
  Grid grid;
  std::optional<Window> window;  // what is seen of it; all if not given
  double rotation = 0.0;         // rad, counterclockwise, about the middle of what is seen
  double magnification = 0.0;    // of displacements; 0 is the plate at rest
  int width = 1280;              // px, even
  double cell = 0.0;             // px; 0: as large as the width allows
  int bare_height = 0;           // px; above 0 the plate alone, stretched to fill the picture
  FieldStyle field;
  std::optional<FieldStyle> second;              // of another field
  Arrangement arrangement = Arrangement::below;  // of the second field
  std::string title;                             // may be empty
  OverlayOptions overlay;                        // but for its title
  Background background = Background::dark;
  std::string note;          // how the plate is shown, "deformed × 100"; may be empty
  double slow_motion = 0.0;  // how many times slower than it is; 0: not said
};

}  // namespace hackle
