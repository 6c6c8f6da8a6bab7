// SPDX-License-Identifier: MIT
// Draws lines, areas and texts with Cairo, on the pixels of an image or in a file of vectors.
// Lengths in px, y downwards.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include <cairo.h>

#include "base/image.hpp"
#include "render/colour_map.hpp"
#include "render/overlay/font.hpp"
#include "render/overlay/rectangle.hpp"
#include "scene/vec2.hpp"

namespace hackle {

class Canvas {
 public:
  // Draws over the content of the image, which must outlive the canvas. The upper left corner of
  // the image has the coordinates `x`, `y`.
  explicit Canvas(Image& image, int x = 0, int y = 0);
  // Draws vectors on the surface, of which it takes hold; `unit` is the length of a px there. Texts
  // are as the printer or the screen has them, not fitted to px.
  Canvas(cairo_surface_t* vectors, double unit);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  // Completes what is drawn; nothing may be drawn after it. Returns whether all of it succeeded.
  cairo_status_t finish();

  void colour(Colour colour, double opacity = 1.0);
  void fill(double x, double y, double width, double height);
  // Fills a polygon.
  void fill(std::span<const Vec2> corners);
  // Draws a frame of this width around the rectangle.
  void outline(const Rectangle& r, int width);
  // Draws only inside the rectangle.
  void within(const Rectangle& r, const std::function<void()>& draw);
  void line(std::span<const Vec2> points, double width);
  // Draws a translucent disc with a bright rim.
  void disc(const Vec2& centre, double radius_x, double radius_y, Colour colour);
  // Likewise a box.
  void box(double x, double y, double width, double height, Colour colour);
  void dot(const Vec2& centre, double radius);
  // Draws a part of an image px by px, with its upper left corner at x, y.
  void copy(const Image& image, const Rectangle& part, int x, int y);
  // Draws an image with its upper left corner at x, y, scaled.
  void picture(cairo_surface_t* from, double x, double y, double scale);

  void write(const Font& font, const PlacedText& text);
  // Writes with a rim in another colour, so that the text is legible on any ground.
  void write(const Font& font, const PlacedText& text, Colour rim);

 private:
  void fill_and_rim(Colour colour);  // the present path
  void set_font(const Font& font, double size);

  struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  };
  std::unique_ptr<cairo_surface_t, Free> surface_;
  std::unique_ptr<cairo_t, Free> cairo_;
  bool vectors_ = false;
};

}  // namespace hackle
