// SPDX-License-Identifier: MIT
#include "render/overlay/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace hackle {

Canvas::Canvas(Image& image, int x, int y)
    : surface_(cairo_image_surface_create_for_data(image.pixels.data(), CAIRO_FORMAT_ARGB32,
                                                   image.width, image.height, image.stride())),
      cairo_(cairo_create(surface_.get())) {
  if (cairo_status(cairo_.get()) != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::run_failed, "Cairo cannot draw on the picture");
  cairo_translate(cairo_.get(), -x, -y);
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
}

Canvas::Canvas(cairo_surface_t* vectors, double unit)
    : surface_(vectors), cairo_(cairo_create(surface_.get())), vectors_(true) {
  if (cairo_status(cairo_.get()) != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::run_failed, "Cairo cannot draw vectors");
  cairo_scale(cairo_.get(), unit, unit);
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
}

Canvas::~Canvas() {
  cairo_surface_flush(surface_.get());
}

cairo_status_t Canvas::finish() {
  const cairo_status_t drawn = cairo_status(cairo_.get());
  cairo_.reset();
  cairo_surface_finish(surface_.get());
  return drawn == CAIRO_STATUS_SUCCESS ? cairo_surface_status(surface_.get()) : drawn;
}

void Canvas::colour(Colour c, double opacity) {
  cairo_set_source_rgba(cairo_.get(), c.red / 255.0, c.green / 255.0, c.blue / 255.0, opacity);
}

void Canvas::fill(double x, double y, double width, double height) {
  cairo_rectangle(cairo_.get(), x, y, width, height);
  cairo_fill(cairo_.get());
}

void Canvas::fill(std::span<const Vec2> corners) {
  for (const Vec2& corner : corners) cairo_line_to(cairo_.get(), corner.x(), corner.y());
  cairo_fill(cairo_.get());
}

void Canvas::outline(const Rectangle& r, int width) {
  fill(r.x - width, r.y - width, r.width + 2 * width, width);
  fill(r.x - width, r.bottom(), r.width + 2 * width, width);
  fill(r.x - width, r.y, width, r.height);
  fill(r.right(), r.y, width, r.height);
}

void Canvas::within(const Rectangle& r, const std::function<void()>& draw) {
  cairo_save(cairo_.get());
  cairo_rectangle(cairo_.get(), r.x, r.y, r.width, r.height);
  cairo_clip(cairo_.get());
  draw();
  cairo_restore(cairo_.get());
}

void Canvas::copy(const Image& image, const Rectangle& part, int x, int y) {
  if (part.empty()) return;
  // Cairo only reads the pixels here, though its interface takes a non-const pointer.
  auto* first = const_cast<std::uint8_t*>(image.pixels.data()) +
                static_cast<std::ptrdiff_t>(part.y) * image.stride() + std::ptrdiff_t{4} * part.x;
  const std::unique_ptr<cairo_surface_t, Free> pixels(cairo_image_surface_create_for_data(
      first, CAIRO_FORMAT_ARGB32, part.width, part.height, image.stride()));
  cairo_set_source_surface(cairo_.get(), pixels.get(), x, y);
  cairo_pattern_set_filter(cairo_get_source(cairo_.get()), CAIRO_FILTER_NEAREST);
  cairo_rectangle(cairo_.get(), x, y, part.width, part.height);
  cairo_fill(cairo_.get());
}

// A point nearer than half a pixel to the last one is invisible.
void Canvas::line(std::span<const Vec2> points, double width) {
  if (points.empty()) return;
  constexpr double min = 0.5;
  Vec2 last = points.front();
  cairo_move_to(cairo_.get(), last.x(), last.y());
  for (const Vec2& point : points) {
    if ((point - last).squaredNorm() < min * min && &point != &points.back()) continue;
    cairo_line_to(cairo_.get(), point.x(), point.y());
    last = point;
  }
  cairo_set_line_width(cairo_.get(), width);
  cairo_stroke(cairo_.get());
}

void Canvas::disc(const Vec2& centre, double radius_x, double radius_y, Colour c) {
  cairo_save(cairo_.get());
  cairo_translate(cairo_.get(), centre.x(), centre.y());
  cairo_scale(cairo_.get(), radius_x, radius_y);
  cairo_arc(cairo_.get(), 0.0, 0.0, 1.0, 0.0, 2.0 * std::numbers::pi);
  cairo_restore(cairo_.get());
  fill_and_rim(c);
}

void Canvas::box(double x, double y, double width, double height, Colour c) {
  cairo_rectangle(cairo_.get(), x, y, width, height);
  fill_and_rim(c);
}

void Canvas::fill_and_rim(Colour c) {
  colour(c, 0.55);
  cairo_fill_preserve(cairo_.get());
  colour(c);
  cairo_set_line_width(cairo_.get(), 1.5);
  cairo_stroke(cairo_.get());
}

void Canvas::dot(const Vec2& centre, double radius) {
  cairo_arc(cairo_.get(), centre.x(), centre.y(), radius, 0.0, 2.0 * std::numbers::pi);
  cairo_fill(cairo_.get());
}

void Canvas::picture(cairo_surface_t* from, double x, double y, double scale) {
  cairo_save(cairo_.get());
  cairo_translate(cairo_.get(), x, y);
  cairo_scale(cairo_.get(), scale, scale);
  cairo_set_source_surface(cairo_.get(), from, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo_.get()), CAIRO_FILTER_BEST);
  cairo_paint(cairo_.get());
  cairo_restore(cairo_.get());
}

void Canvas::set_font(const Font& font, double size) {
  if (!vectors_) return cairo_set_scaled_font(cairo_.get(), font.scaled(size).get());
  const std::unique_ptr<cairo_font_options_t, void (*)(cairo_font_options_t*)> options(
      cairo_font_options_create(), cairo_font_options_destroy);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_face(cairo_.get(), font.face());
  cairo_set_font_size(cairo_.get(), size);
  cairo_set_font_options(cairo_.get(), options.get());
}

void Canvas::write(const Font& font, const PlacedText& text) {
  set_font(font, text.size);
  colour(text.colour);
  cairo_move_to(cairo_.get(), text.x, text.y);
  cairo_show_text(cairo_.get(), text.text.c_str());
  cairo_new_path(cairo_.get());  // what is drawn next would begin where the text ends
}

void Canvas::write(const Font& font, const PlacedText& text, Colour rim) {
  set_font(font, text.size);
  cairo_move_to(cairo_.get(), text.x, text.y);
  cairo_text_path(cairo_.get(), text.text.c_str());
  colour(rim, 0.85);
  cairo_set_line_width(cairo_.get(), 2.0 * std::max(0.8, 0.08 * text.size));
  cairo_stroke(cairo_.get());
  write(font, text);
}

}  // namespace hackle
