// SPDX-License-Identifier: MIT
// The font of all pictures: measures texts and shortens them to fit.
#pragma once

#include <memory>
#include <string>

#include <cairo.h>

#include "render/colour_map.hpp"

namespace hackle {

// A text at whole pixels, so that it is sharp.
struct PlacedText {
  std::string text;
  double x = 0.0, y = 0.0;  // px, start of its base line
  double size = 0.0;        // px
  Colour colour;
};

class Font {
 public:
  // Throws Error (files), which names the Debian package, if the machine lacks the family: Cairo
  // would silently take another.
  explicit Font(const char* family = "DejaVu Sans");

  // Returns the advance width of the text, px.
  double width_of(const std::string& text, double size) const;
  // Returns the text, or as much of it as fits into `width` px with an ellipsis; "" if not even
  // that fits.
  std::string fitting(const std::string& text, double size, double width) const;
  // Places a text. `anchor` 0: it begins at x; 0.5: it is centred on x; 1: it ends at x. `y` is its
  // base line.
  PlacedText place(const std::string& text, double x, double y, double size, double anchor,
                   Colour colour) const;

  // Hinted and in shades of grey: whole pixels and crisp stems.
  using Scaled = std::unique_ptr<cairo_scaled_font_t, void (*)(cairo_scaled_font_t*)>;
  Scaled scaled(double size) const;
  cairo_font_face_t* face() const { return face_.get(); }

 private:
  std::unique_ptr<cairo_font_face_t, void (*)(cairo_font_face_t*)> face_;
};

}  // namespace hackle
