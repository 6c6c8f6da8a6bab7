// SPDX-License-Identifier: MIT
#pragma once

namespace hackle {

// In px from the upper left corner.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;

  int right() const { return x + width; }
  int bottom() const { return y + height; }
  bool empty() const { return width <= 0 || height <= 0; }
};

}  // namespace hackle
