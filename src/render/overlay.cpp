// SPDX-License-Identifier: MIT
#include "render/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <cairo.h>
#include <fmt/format.h>

#include "base/error.hpp"

namespace hackle {
namespace {

constexpr Colour text_colour{222, 228, 236};
constexpr Colour disc_colour{150, 170, 190};
constexpr Colour quiet_colour{140, 150, 166};

// A Cairo context on the pixels of an image.
class Canvas {
 public:
  explicit Canvas(Image& image)
      : surface_(cairo_image_surface_create_for_data(image.pixels.data(), CAIRO_FORMAT_RGB24,
                                                     image.width, image.height, image.stride())),
        cairo_(cairo_create(surface_.get())) {
    if (cairo_status(cairo_.get()) != CAIRO_STATUS_SUCCESS)
      throw Error(ErrorKind::run_failed, "Cairo cannot draw on the picture");
    cairo_select_font_face(cairo_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
  }
  ~Canvas() { cairo_surface_flush(surface_.get()); }

  void colour(Colour c) {
    cairo_set_source_rgb(cairo_.get(), c.red / 255.0, c.green / 255.0, c.blue / 255.0);
  }
  void fill(double x, double y, double width, double height) {
    cairo_rectangle(cairo_.get(), x, y, width, height);
    cairo_fill(cairo_.get());
  }
  void outline(const Rectangle& r) {
    cairo_set_line_width(cairo_.get(), 1.0);
    cairo_rectangle(cairo_.get(), r.x - 0.5, r.y - 0.5, r.width + 1.0, r.height + 1.0);
    cairo_stroke(cairo_.get());
  }
  void clip(double y, double height, double width) {
    cairo_rectangle(cairo_.get(), 0.0, y, width, height);
    cairo_clip(cairo_.get());
  }
  // Seen through a little, with a bright rim.
  void disc(double x, double y, double radius_x, double radius_y, Colour c) {
    cairo_save(cairo_.get());
    cairo_translate(cairo_.get(), x, y);
    cairo_scale(cairo_.get(), radius_x, radius_y);
    cairo_arc(cairo_.get(), 0.0, 0.0, 1.0, 0.0, 2.0 * std::numbers::pi);
    cairo_restore(cairo_.get());
    cairo_set_source_rgba(cairo_.get(), c.red / 255.0, c.green / 255.0, c.blue / 255.0, 0.55);
    cairo_fill_preserve(cairo_.get());
    colour(c);
    cairo_set_line_width(cairo_.get(), 1.5);
    cairo_stroke(cairo_.get());
  }
  double width_of(const std::string& text, double size) {
    cairo_set_font_size(cairo_.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_.get(), text.c_str(), &extents);
    return extents.x_advance;
  }
  // `anchor` 0: the text begins at x; 0.5: is centred on it; 1: ends there. `y` is its base line.
  void write(const std::string& text, double x, double y, double size, double anchor) {
    const double left = std::round(x - anchor * width_of(text, size));
    cairo_move_to(cairo_.get(), left, std::round(y));
    cairo_show_text(cairo_.get(), text.c_str());
  }

 private:
  struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  };
  std::unique_ptr<cairo_surface_t, Free> surface_;
  std::unique_ptr<cairo_t, Free> cairo_;
};

void draw_colours(Canvas& canvas, const Rectangle& bar, const ColourMap& map) {
  for (int x = 0; x < bar.width; ++x) {
    const std::size_t last = map.colours.size() - 1;
    const auto pixel = static_cast<std::size_t>(x), pixels = static_cast<std::size_t>(bar.width);
    canvas.colour(map.colours[pixel * last / std::max<std::size_t>(1, pixels - 1)]);
    canvas.fill(bar.x + x, bar.y, 1, bar.height);
  }
}

// The distance of ticks: neat, at most five intervals, and numbers that do not touch.
double tick_step(double span, double bar_width, double font) {
  const double intervals = std::clamp(bar_width / (3.0 * font), 1.0, 5.0);
  const double least = span / intervals * (1.0 - 1e-9);
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0})
    if (factor * decade >= least) return factor * decade;
  return span;
}

// Where ticks stand: neat values, on a logarithmic scale powers of ten.
std::vector<double> ticks(const OverlayText& text, double bar_width, double font) {
  std::vector<double> values;
  if (text.logarithmic) {
    constexpr double slack = 1e-9;
    const int first = static_cast<int>(std::ceil(std::log10(text.least) - slack));
    const int last = static_cast<int>(std::floor(std::log10(text.most) + slack));
    for (int power = first; power <= last; ++power) values.push_back(std::pow(10.0, power));
    return values;
  }
  const double span = text.most - text.least;
  const double step = tick_step(span, bar_width, font);
  const auto first = static_cast<int>(std::ceil(text.least / step - 1e-9));
  const auto last = static_cast<int>(std::floor(text.most / step + 1e-9));
  for (int k = first; k <= last; ++k) values.push_back(k * step);
  return values;
}

double share_of(double value, const OverlayText& text) {
  if (text.logarithmic) return std::log(value / text.least) / std::log(text.most / text.least);
  return (value - text.least) / (text.most - text.least);
}

void draw_ticks(Canvas& canvas, const Layout& layout, const OverlayText& text) {
  const Rectangle& bar = layout.bar;
  const double base = bar.bottom() + 0.4 * layout.font + 0.85 * layout.small_font;
  canvas.colour(quiet_colour);
  for (const double value : ticks(text, bar.width, layout.small_font)) {
    const double share = share_of(value, text);
    const double x = bar.x + std::round(share * (bar.width - 1));
    canvas.fill(x, bar.bottom(), 1, std::round(0.25 * layout.font));
    // The last colour stands for everything above, too, and the first for everything below.
    const char* beyond = share > 1.0 - 1e-6 ? "≥" : share < 1e-6 && value != 0.0 ? "≤" : "";
    canvas.write(fmt::format("{}{:.4g}", beyond, value), x, base, layout.small_font, 0.5);
  }
}

void draw_scale(Canvas& canvas, const Layout& layout, double metres_per_pixel) {
  const double most = std::min<double>(layout.scale.width, layout.plate.width / 5.0);
  const double length = neat_at_most(most * metres_per_pixel);
  const double pixels = length / metres_per_pixel;
  const double right = layout.scale.right();
  const double y = layout.bar.y + 0.5 * layout.bar.height;
  const double thickness = std::max(2.0, std::round(0.14 * layout.font));
  const double serif = std::round(0.35 * layout.font);
  canvas.colour(text_colour);
  canvas.fill(right - pixels, y - 0.5 * thickness, pixels, thickness);
  canvas.fill(right - pixels, y - serif, std::max(1.0, thickness / 2), 2 * serif);
  canvas.fill(right - std::max(1.0, thickness / 2), y - serif, std::max(1.0, thickness / 2),
              2 * serif);
  canvas.write(fmt::format("{:.4g} mm", length * 1e3), right - 0.5 * pixels,
               layout.bar.bottom() + 0.4 * layout.font + 0.85 * layout.small_font,
               layout.small_font, 0.5);
}

}  // namespace

void draw_frame(Image& image, const Layout& layout, const ColourMap& map, const OverlayText& text) {
  Canvas canvas(image);
  canvas.colour({70, 82, 102});
  canvas.outline(layout.plate);
  draw_colours(canvas, layout.bar, map);
  draw_ticks(canvas, layout, text);
  draw_scale(canvas, layout, text.metres_per_pixel);
  canvas.colour(text_colour);
  canvas.write(text.label, layout.caption.x, layout.bar.bottom(), layout.font, 0.0);
  if (!text.title.empty())
    canvas.write(text.title, layout.caption.x, layout.caption.y + layout.font, layout.font, 0.0);
}

void draw_time(Image& image, const Layout& layout, double time) {
  Canvas canvas(image);
  canvas.colour(text_colour);
  canvas.write(time_text(time), layout.caption.right(), layout.caption.y + layout.font, layout.font,
               1.0);
}

void draw_discs(Image& image, const Layout& layout, const Grid& grid,
                const std::vector<Circle>& discs) {
  if (discs.empty()) return;
  Canvas canvas(image);
  const double top = layout.caption.bottom(), below = layout.bar.y - 0.5 * layout.font;
  canvas.clip(top, below - top, image.width);
  const double across = layout.plate.width / (grid.nx * grid.dx);  // px/m
  const double up = layout.plate.height / (grid.ny * grid.dx);
  for (const Circle& disc : discs) {
    const Vec2 place = disc.centre - grid.centre;
    canvas.disc(layout.plate.x + 0.5 * layout.plate.width + place.x() * across,
                layout.plate.y + 0.5 * layout.plate.height - place.y() * up, disc.radius * across,
                disc.radius * up, disc_colour);
  }
}

std::string time_text(double time) {
  if (time < 1e-3) return fmt::format("{:.2f} µs", time * 1e6);
  return fmt::format("{:.4f} ms", time * 1e3);
}

}  // namespace hackle
