// SPDX-License-Identifier: MIT
// A complete picture of a plate: the field in colours, colour bar, time and scale bar.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.hpp"
#include "lattice/grid.hpp"
#include "measure/scalar.hpp"
#include "render/chart.hpp"
#include "render/layout.hpp"
#include "render/overlay_text.hpp"

namespace hackle {

// What all pictures of one series have in common.
struct PictureStyle {
  Grid grid;
  std::optional<Window> window;       // what is seen of it; all if not given
  int width = 1280;                   // px, even
  int bare_height = 0;                // px; above 0 the plate alone, stretched to fill the picture
  std::string colour_map = "damage";  // one of colour_map_names, or fringes_name
  double least = 0.0;                 // the values at the two ends of the colour bar, in SI;
  double most = 0.5;                  // least < most, and above 0 if the scale is logarithmic
  bool logarithmic = false;
  Sampling sampling = Sampling::largest;
  std::string title;             // may be empty
  std::string label = "damage";  // of the colour bar
  std::string unit;              // of the values, SI; may be empty
  OverlayOptions overlay;        // but for its title
  Background background = Background::dark;
  std::string note;          // how the plate is shown, "deformed × 100"; may be empty
  double slow_motion = 0.0;  // how many times slower than it is; 0: not said
};

// What is painted at one time, by Grid::index.
struct Shot {
  std::vector<float> values;  // nan where the background is to be seen
  std::vector<float> gaps;    // damage, to be seen as gaps of the plate; empty where it is not
  double time = 0.0;          // s
  std::vector<Circle> discs;
  Chart load_curve, energy;  // where the overlay has them
};

// Where everything lies in the pictures of a series.
Layout layout_of(const PictureStyle& style);

// Owns a GL context, so it must be used, and destroyed, by the thread that created it.
class PlatePainter {
 public:
  // Throws Error (files) when a shader, colour map or font is missing, Error (run_failed) when no
  // GL context can be had.
  explicit PlatePainter(PictureStyle style);
  ~PlatePainter();

  int width() const;   // px, even unless bare
  int height() const;  // px, even, from the shape of what is seen; or as the style says

  // Discs are drawn where they are now, over the plate as it was at rest.
  Image paint(const Shot& shot);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
