// SPDX-License-Identifier: MIT
#include "render/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <cairo.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "render/overlay.hpp"

namespace hackle {
namespace {

struct Free {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};
using Surface = std::unique_ptr<cairo_surface_t, Free>;
using Cairo = std::unique_ptr<cairo_t, Free>;

constexpr Colour title_colour{222, 228, 236};

// Lengths in px.
struct Measures {
  explicit Measures(const SheetLayout& layout)
      : width(layout.width),
        height(layout.height > 0 ? layout.height : std::round(0.75 * layout.width)),
        gap(std::max(4.0, std::round(0.04 * layout.width))),
        font(std::max(10.0, std::round(layout.font * layout.width))),
        pitch(height + (layout.titled ? 2.2 * font + 0.5 * gap : gap)) {}
  double width, height, gap, font;
  double pitch;  // from the top of a cell to that of the one below it
};

Surface read(const std::filesystem::path& file) {
  Surface surface(cairo_image_surface_create_from_png(file.c_str()));
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::files, fmt::format("cannot read the picture '{}': {}", file.string(),
                                              cairo_status_to_string(status)));
  return surface;
}

void set_colour(cairo_t* cairo, Colour c) {
  cairo_set_source_rgb(cairo, c.red / 255.0, c.green / 255.0, c.blue / 255.0);
}

// In the middle of the cell whose upper left corner is at x, y.
void draw_picture(cairo_t* cairo, const Measures& cell, double x, double y, cairo_surface_t* from) {
  const double width = cairo_image_surface_get_width(from);
  const double height = cairo_image_surface_get_height(from);
  const double scale = std::min(cell.width / width, cell.height / height);
  cairo_save(cairo);
  cairo_translate(cairo, x + 0.5 * (cell.width - scale * width),
                  y + 0.5 * (cell.height - scale * height));
  cairo_scale(cairo, scale, scale);
  cairo_set_source_surface(cairo, from, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_BEST);
  cairo_paint(cairo);
  cairo_restore(cairo);
}

double width_of(cairo_t* cairo, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  return extents.x_advance;
}

// Without its last character; UTF-8.
void shorten(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U)
    text.pop_back();
  if (!text.empty()) text.pop_back();
}

std::string fitting(cairo_t* cairo, std::string title, double width) {
  if (width_of(cairo, title) <= width) return title;
  while (!title.empty() && width_of(cairo, title + "…") > width) shorten(title);
  return title + "…";
}

void draw_title(cairo_t* cairo, const Measures& cell, double x, double y,
                const std::string& title) {
  set_colour(cairo, title_colour);
  const std::string text = fitting(cairo, title, cell.width);
  cairo_move_to(cairo, std::round(x + 0.5 * (cell.width - width_of(cairo, text))),
                std::round(y + cell.height + 1.4 * cell.font));
  cairo_show_text(cairo, text.c_str());
}

Image blank(const Measures& cell, int columns, int rows, bool even) {
  const double width = columns * (cell.width + cell.gap) + cell.gap;
  const double height = rows * cell.pitch + cell.gap;
  if (width > most_of_sheet || height > most_of_sheet)
    throw Error(ErrorKind::refused,
                fmt::format("contact_sheet: the sheet would be {:.0f} x {:.0f} px, more than {}",
                            width, height, most_of_sheet),
                "give a smaller width or fewer pictures");
  const int odd = even ? 1 : 0;
  const int w = static_cast<int>(width), h = static_cast<int>(height);
  return {w + (w & odd), h + (h & odd)};
}

// Of `count` cells; picture(k) is the surface of each and title(k) its text.
template <class Picture, class Title>
Image sheet_of(int count, const SheetLayout& layout, Picture picture, Title title) {
  if (count == 0) throw Error(ErrorKind::refused, "contact_sheet: there is no picture");
  const int columns = std::min(layout.columns, count);
  const Measures cell(layout);
  Image sheet = blank(cell, columns, (count + columns - 1) / columns, layout.even);
  const Surface surface(cairo_image_surface_create_for_data(
      sheet.pixels.data(), CAIRO_FORMAT_RGB24, sheet.width, sheet.height, sheet.stride()));
  const Cairo cairo(cairo_create(surface.get()));
  set_colour(cairo.get(), background_colour);
  cairo_paint(cairo.get());
  cairo_select_font_face(cairo.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo.get(), cell.font);
  for (int k = 0; k < count; ++k) {
    const double x = cell.gap + k % columns * (cell.width + cell.gap);
    const double y = cell.gap + k / columns * cell.pitch;
    const Surface one = picture(static_cast<std::size_t>(k));
    draw_picture(cairo.get(), cell, x, y, one.get());
    draw_title(cairo.get(), cell, x, y, title(static_cast<std::size_t>(k)));
  }
  cairo_surface_flush(surface.get());
  return sheet;
}

}  // namespace

Image contact_sheet(const std::vector<SheetPicture>& pictures, const SheetLayout& layout) {
  return sheet_of(
      static_cast<int>(pictures.size()), layout,
      [&](std::size_t k) { return read(pictures[k].file); },
      [&](std::size_t k) { return pictures[k].title; });
}

Image contact_sheet(std::vector<SheetImage>& images, const SheetLayout& layout) {
  return sheet_of(
      static_cast<int>(images.size()), layout,
      [&](std::size_t k) {
        Image& image = images[k].image;
        return Surface(cairo_image_surface_create_for_data(
            image.pixels.data(), CAIRO_FORMAT_RGB24, image.width, image.height, image.stride()));
      },
      [&](std::size_t k) { return images[k].title; });
}

}  // namespace hackle
