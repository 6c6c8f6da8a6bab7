// SPDX-License-Identifier: MIT
#include "render/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "render/overlay/canvas.hpp"
#include "render/png_reader.hpp"
#include "render/theme.hpp"

namespace hackle {
namespace {

using CairoSurface = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

// Lengths in px.
struct Measures {
  explicit Measures(const SheetLayout& layout)
      : width(layout.width),
        height(layout.height > 0 ? layout.height : std::round(0.75 * layout.width)),
        gap(std::max(4.0, std::round(0.04 * layout.width))),
        font(std::max(10.0, std::round(layout.font * layout.width))),
        pitch(height + (layout.titled ? 2.2 * font + 0.5 * gap : gap)) {}
  double width, height, gap, font;
  double pitch;  // from the top of a cell to the top of the next below
};

CairoSurface read(const std::filesystem::path& file) {
  check_png(file);
  CairoSurface surface(cairo_image_surface_create_from_png(file.c_str()), cairo_surface_destroy);
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::files, fmt::format("cannot read the picture '{}': {}", file.string(),
                                              cairo_status_to_string(status)));
  return surface;
}

// Draws the picture in the middle of the cell with its upper left corner at x, y.
void draw_picture(Canvas& canvas, const Measures& cell, double x, double y, cairo_surface_t* from) {
  const double width = cairo_image_surface_get_width(from);
  const double height = cairo_image_surface_get_height(from);
  const double scale = std::min(cell.width / width, cell.height / height);
  canvas.picture(from, x + 0.5 * (cell.width - scale * width),
                 y + 0.5 * (cell.height - scale * height), scale);
}

void draw_title(Canvas& canvas, const Font& font, const Measures& cell, double x, double y,
                const std::string& title, Colour colour) {
  const std::string text = font.fitting(title, cell.font, cell.width);
  canvas.write(font, font.place(text, x + 0.5 * cell.width, y + cell.height + 1.4 * cell.font,
                                cell.font, 0.5, colour));
}

Image blank(const Measures& cell, int columns, int rows, bool even) {
  const double width = columns * (cell.width + cell.gap) + cell.gap;
  const double height = rows * cell.pitch + cell.gap;
  if (width > max_of_sheet || height > max_of_sheet)
    throw Error(ErrorKind::refused,
                fmt::format("contact_sheet: the sheet would be {:.0f} x {:.0f} px, more than {}",
                            width, height, max_of_sheet),
                "give a smaller width or fewer pictures");
  const int odd = even ? 1 : 0;
  const int w = static_cast<int>(width), h = static_cast<int>(height);
  return {w + (w & odd), h + (h & odd)};
}

// Draws a sheet of `count` cells; picture(k) is the surface of each and title(k) its text.
template <class Picture, class Title>
Image sheet_of(int count, const SheetLayout& layout, Picture picture, Title title) {
  if (count == 0) throw Error(ErrorKind::refused, "contact_sheet: there is no picture");
  const int columns = std::min(layout.columns, count);
  const Measures cell(layout);
  Image sheet = blank(cell, columns, (count + columns - 1) / columns, layout.even);
  const Font font;
  Canvas canvas(sheet);
  const Theme& theme = theme_of(ground_of(layout.look));
  canvas.colour(theme.background);
  canvas.fill(0, 0, sheet.width, sheet.height);
  for (int k = 0; k < count; ++k) {
    throw_if_interrupted();
    const int column = k % columns, row = k / columns;
    const double x = cell.gap + column * (cell.width + cell.gap);
    const double y = cell.gap + row * cell.pitch;
    draw_picture(canvas, cell, x, y, picture(static_cast<std::size_t>(k)).get());
    draw_title(canvas, font, cell, x, y, title(static_cast<std::size_t>(k)), theme.text);
  }
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
        return CairoSurface(
            cairo_image_surface_create_for_data(image.pixels.data(), CAIRO_FORMAT_RGB24,
                                                image.width, image.height, image.stride()),
            cairo_surface_destroy);
      },
      [&](std::size_t k) { return images[k].title; });
}

}  // namespace hackle
