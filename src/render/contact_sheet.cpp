// SPDX-License-Identifier: MIT
#include "render/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "base/error.hpp"
#include "render/canvas.hpp"
#include "render/theme.hpp"

namespace hackle {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

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
  Surface surface(cairo_image_surface_create_from_png(file.c_str()), cairo_surface_destroy);
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::files, fmt::format("cannot read the picture '{}': {}", file.string(),
                                              cairo_status_to_string(status)));
  return surface;
}

// In the middle of the cell whose upper left corner is at x, y.
void draw_picture(Canvas& canvas, const Measures& cell, double x, double y, cairo_surface_t* from) {
  const double width = cairo_image_surface_get_width(from);
  const double height = cairo_image_surface_get_height(from);
  const double scale = std::min(cell.width / width, cell.height / height);
  canvas.picture(from, x + 0.5 * (cell.width - scale * width),
                 y + 0.5 * (cell.height - scale * height), scale);
}

void draw_title(Canvas& canvas, const Font& font, const Measures& cell, double x, double y,
                const std::string& title) {
  const std::string text = font.fitting(title, cell.font, cell.width);
  canvas.write(font, font.place(text, x + 0.5 * cell.width, y + cell.height + 1.4 * cell.font,
                                cell.font, 0.5, theme_of(Background::dark).text));
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
  const Font font;
  Canvas canvas(sheet);
  canvas.colour(background_colour);
  canvas.fill(0, 0, sheet.width, sheet.height);
  for (int k = 0; k < count; ++k) {
    const int column = k % columns, row = k / columns;
    const SheetPicture& one = pictures[static_cast<std::size_t>(k)];
    const double x = cell.gap + column * (cell.width + cell.gap), y = cell.gap + row * cell.pitch;
    draw_picture(canvas, cell, x, y, read(one.file).get());
    draw_title(canvas, font, cell, x, y, one.title);
  }
  return sheet;
}

}  // namespace hackle
