// SPDX-License-Identifier: MIT
// Coordinates of the plate along its left and its lower side, in mm.
#pragma once

#include <vector>

#include "render/camera.hpp"
#include "render/overlay/canvas.hpp"
#include "render/overlay/layout.hpp"
#include "render/theme.hpp"

namespace hackle {

class Axes {
 public:
  // Around one of the plates of the layout, which has room for them; the camera must not turn.
  Axes(const Rectangle& plate, const Camera& camera, const Layout& layout, const Theme& theme,
       const Font& font);

  void draw(Canvas& canvas) const;
  // Returns the numbers, the last one along x with the unit.
  const std::vector<PlacedText>& texts() const { return texts_; }

 private:
  void place_across(const Camera& camera, const Font& font);
  void place_upwards(const Camera& camera, const Font& font);

  Rectangle plate_;
  double size_;              // px, of the numbers
  int mark_ = 0, hairline_;  // px, length and width of marks
  Colour colour_;
  std::vector<double> across_, upwards_;  // px of the marks
  std::vector<PlacedText> texts_;
};

}  // namespace hackle
