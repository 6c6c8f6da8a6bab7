// SPDX-License-Identifier: MIT
// A complete picture of a plate: the field in colours, colour bar, time and scale bar.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.hpp"
#include "lattice/grid.hpp"
#include "measure/field.hpp"
#include "render/layout.hpp"

namespace hackle {

// What all pictures of one series have in common.
struct PictureStyle {
  Grid grid;
  std::optional<Window> window;       // what is seen of it; all if not given
  int width = 1280;                   // px, even
  int bare_height = 0;                // px; above 0 the plate alone, stretched to fill the picture
  std::string colour_map = "damage";  // a file of assets/colour_maps, without its ending
  double least = 0.0;                 // the values at the two ends of the colour bar, in SI
  double most = 0.5;
  std::string title;  // may be empty
};

// Owns a GL context, so it must be used, and destroyed, by the thread that created it.
class PlatePainter {
 public:
  // Throws Error (files) when a shader, colour map or font is missing, Error (run_failed) when no
  // GL context can be had.
  explicit PlatePainter(PictureStyle style);
  ~PlatePainter();

  int width() const;   // px, even unless bare
  int height() const;  // px, even, from the shape of what is seen; or as the style says

  // `field` has one component. `time` in s. Discs are drawn where they are now, over the plate as
  // it was at rest.
  Image paint(const Field& field, double time, const std::vector<Circle>& discs = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
