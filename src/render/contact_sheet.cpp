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
        height(std::round(0.75 * layout.width)),
        gap(std::max(4.0, std::round(0.04 * layout.width))),
        font(std::max(10.0, std::round(0.05 * layout.width))),
        pitch(height + 2.2 * font + 0.5 * gap) {}
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

void draw_cell(cairo_t* cairo, const Measures& cell, double x, double y, const SheetPicture& one) {
  const Surface picture = read(one.file);
  draw_picture(cairo, cell, x, y, picture.get());
  draw_title(cairo, cell, x, y, one.title);
}

Image blank(const Measures& cell, int columns, int rows) {
  const double width = columns * (cell.width + cell.gap) + cell.gap;
  const double height = rows * cell.pitch + cell.gap;
  if (width > most_of_sheet || height > most_of_sheet)
    throw Error(ErrorKind::refused,
                fmt::format("contact_sheet: the sheet would be {:.0f} x {:.0f} px, more than {}",
                            width, height, most_of_sheet),
                "give a smaller width or fewer pictures");
  return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace

Image contact_sheet(const std::vector<SheetPicture>& pictures, const SheetLayout& layout) {
  if (pictures.empty()) throw Error(ErrorKind::refused, "contact_sheet: there is no picture");
  const int count = static_cast<int>(pictures.size());
  const int columns = std::min(layout.columns, count);
  const Measures cell(layout);
  Image sheet = blank(cell, columns, (count + columns - 1) / columns);
  const Surface surface(cairo_image_surface_create_for_data(
      sheet.pixels.data(), CAIRO_FORMAT_RGB24, sheet.width, sheet.height, sheet.stride()));
  const Cairo cairo(cairo_create(surface.get()));
  set_colour(cairo.get(), background_colour);
  cairo_paint(cairo.get());
  cairo_select_font_face(cairo.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo.get(), cell.font);
  for (int k = 0; k < count; ++k) {
    const int column = k % columns, row = k / columns;
    draw_cell(cairo.get(), cell, cell.gap + column * (cell.width + cell.gap),
              cell.gap + row * cell.pitch, pictures[static_cast<std::size_t>(k)]);
  }
  cairo_surface_flush(surface.get());
  return sheet;
}

}  // namespace hackle
