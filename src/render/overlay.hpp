// SPDX-License-Identifier: MIT
// Texts and bars around the plate, drawn with Cairo on the pixels of the picture.
#pragma once

#include <string>
#include <vector>

#include "base/image.hpp"
#include "measure/field.hpp"
#include "render/colour_map.hpp"
#include "render/layout.hpp"

namespace hackle {

// What the texts say.
struct OverlayText {
  std::string title;   // may be empty
  std::string label;   // of the colour bar, "speed (m/s)"
  double least = 0.0;  // value at the left end of the colour bar, in the unit of the label
  double most = 1.0;   // value at its right end; larger ones have its colour
  bool logarithmic = false;
  double metres_per_pixel = 0.0;
};

// Everything that is the same on all pictures of a series: rim of the plate, colour bar, scale bar.
void draw_frame(Image& image, const Layout& layout, const ColourMap& map, const OverlayText& text);

// The time, in s, at the right end of the caption.
void draw_time(Image& image, const Layout& layout, double time);

// Discs, between the caption and the legend. `grid` is what is seen of the lattice.
void draw_discs(Image& image, const Layout& layout, const Grid& grid,
                const std::vector<Circle>& discs);

// "22.50 µs"; always two decimals, so that it does not dance.
std::string time_text(double time);

inline constexpr Colour background_colour{15, 18, 24};

}  // namespace hackle
