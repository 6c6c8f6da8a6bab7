// SPDX-License-Identifier: MIT
// Lines, areas and texts on the pixels of an image, drawn with Cairo. Lengths in px, y downwards.
#pragma once

#include <memory>
#include <span>

#include <cairo.h>

#include "base/image.hpp"
#include "render/colour_map.hpp"
#include "render/font.hpp"
#include "render/rectangle.hpp"
#include "scene/vec2.hpp"

namespace hackle {

class Canvas {
 public:
  // Draws over what the image holds, which must outlive the canvas; its upper left corner is at
  // `x`, `y` of what is drawn.
  explicit Canvas(Image& image, int x = 0, int y = 0);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void colour(Colour colour, double opacity = 1.0);
  void fill(double x, double y, double width, double height);
  // Around the rectangle, so many px wide.
  void outline(const Rectangle& r, int width);
  // Nothing is drawn outside of it from now on.
  void clip(const Rectangle& r);
  void line(std::span<const Vec2> points, double width);
  // Seen through a little, with a bright rim.
  void disc(const Vec2& centre, double radius_x, double radius_y, Colour colour);
  void dot(const Vec2& centre, double radius);
  // An image whose upper left corner comes to x, y, grown or shrunk.
  void picture(cairo_surface_t* from, double x, double y, double scale);

  void write(const Font& font, const PlacedText& text);
  // With a rim of the other colour, to be read on any ground.
  void write(const Font& font, const PlacedText& text, Colour rim);

 private:
  void set_font(const Font& font, double size);

  struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  };
  std::unique_ptr<cairo_surface_t, Free> surface_;
  std::unique_ptr<cairo_t, Free> cairo_;
};

}  // namespace hackle
