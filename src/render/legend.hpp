// SPDX-License-Identifier: MIT
// Colour bars and a scale bar for several pictures of one style.
#pragma once

#include <vector>

#include "base/image.hpp"
#include "render/overlay/overlay.hpp"
#include "render/picture_style.hpp"

namespace hackle {

class Legend {
 public:
  // As wide as this, px, for plates of so many px per metre.
  Legend(const PictureStyle& style, int width, double pixels_a_metre);

  // Returns its picture, 0 px high if the style wants neither bar; `beyond` is for each bar.
  Image paint(const std::vector<Beyond>& beyond);

 private:
  Layout layout_;
  Overlay overlay_;
};

}  // namespace hackle
