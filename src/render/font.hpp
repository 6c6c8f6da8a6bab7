// SPDX-License-Identifier: MIT
// The font of all pictures: how much room texts take, and what of them fits.
#pragma once

#include <memory>
#include <string>

#include <cairo.h>

#include "render/colour_map.hpp"

namespace hackle {

// A text on whole pixels, so that it is sharp.
struct PlacedText {
  std::string text;
  double x = 0.0, y = 0.0;  // px, where its base line begins
  double size = 0.0;        // px
  Colour colour;
};

class Font {
 public:
  // Throws Error (files), which names the Debian package, when the machine lacks the family: Cairo
  // would take any other.
  explicit Font(const char* family = "DejaVu Sans");

  // px, from where the text begins to where the next would.
  double width_of(const std::string& text, double size) const;
  // The text, or what of it fits into `width` px before an ellipsis; "" when not even that fits.
  std::string fitting(const std::string& text, double size, double width) const;
  // `anchor` 0: the text begins at x; 0.5: is centred on it; 1: ends there. `y` is its base line.
  PlacedText place(const std::string& text, double x, double y, double size, double anchor,
                   Colour colour) const;

  // Whole pixels and crisp stems: hinted, in shades of grey.
  using Scaled = std::unique_ptr<cairo_scaled_font_t, void (*)(cairo_scaled_font_t*)>;
  Scaled scaled(double size) const;

 private:
  std::unique_ptr<cairo_font_face_t, void (*)(cairo_font_face_t*)> face_;
};

}  // namespace hackle
