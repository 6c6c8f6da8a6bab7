// SPDX-License-Identifier: MIT
// A line of a neat length, to measure the plate by.
#pragma once

#include "render/canvas.hpp"
#include "render/layout.hpp"

namespace hackle {

class ScaleBar {
 public:
  // About a fifth of the plate, but not too short to be seen.
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
