// SPDX-License-Identifier: MIT
// A line of a round length, as a measure of the plate.
#pragma once

#include "render/overlay/canvas.hpp"
#include "render/overlay/layout.hpp"

namespace hackle {

class ScaleBar {
 public:
  // Its length is about a fifth of the plate, but not too short to see.
  ScaleBar(const Layout& layout, const OverlayText& text, const Font& font,
           double metres_per_pixel);

  void draw(Canvas& canvas) const;
  const PlacedText& text() const { return text_; }

 private:
  double left_ = 0.0, right_ = 0.0, y_ = 0.0;  // px
  double thickness_ = 0.0, serif_ = 0.0;       // px
  PlacedText text_;
};

}  // namespace hackle
