// SPDX-License-Identifier: MIT
// The properties that all pictures of a series share.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "lattice/grid.hpp"
#include "measure/scalar.hpp"
#include "render/overlay/layout.hpp"
#include "render/overlay/overlay_text.hpp"

namespace hackle {

// The position of a second field: in the lower or the right half of the plate, for scenes symmetric
// about the midline; over the first field, more opaque for larger values; or on a second plate.
enum class Arrangement { below, right, over, beside };
template <>
inline constexpr auto enum_names<Arrangement> = std::to_array<std::string_view>({"below", "right",
                                                                                 "over", "beside"});

// The appearance of a field.
struct FieldStyle {
  std::string colour_map = "damage";  // one of colour_map_names, or fringes_name
  double min = 0.0;                   // the values at the two ends of the colour bar, in SI;
  double max = 0.5;                   // least < most, and above 0 if the scale is logarithmic
  bool logarithmic = false;
  Sampling sampling = Sampling::largest;
  std::string label = "damage";  // of the colour bar
  std::string unit;              // of the values, SI; may be empty
  bool whole = false;            // the numbers at the colour bar are whole
  bool widens = false;  // the range widens when it does not fit what is seen, see widened()
};

struct PictureStyle {
  Grid grid;
  std::optional<Window> window;  // visible part of the plate; default: all
  double rotation = 0.0;         // rad, anticlockwise, about the centre of the visible part
  double magnification = 0.0;    // of displacements; 0 shows the undeformed plate
  bool encloses = false;         // the window grows where the displaced plate leaves it
  int width = 1280;              // px, even
  double dpi = 300.0;            // px per inch of paper, in a file of vectors
  double font = 0.0;             // px, of titles, time and names; 0: suits the width
  double cell = 0.0;             // px; 0: as large as the width allows
  int bare_height = 0;           // px; if above 0, the plate alone is stretched to fill the picture
  FieldStyle field;
  std::optional<FieldStyle> second;              // a second field
  Arrangement arrangement = Arrangement::below;  // of the second field
  std::string title;                             // may be empty
  OverlayOptions overlay;                        // except its title
  Background background = Background::dark;
  std::string note;          // describes the view, "deformed × 100"; may be empty
  double slow_motion = 0.0;  // slow-motion factor; 0: not shown
  bool smooth = false;       // interpolates between nodes, where cells are larger than px
  bool bonds = false;        // draws bonds and nodes one by one
};

}  // namespace hackle
