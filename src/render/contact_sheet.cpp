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
        gap(std::max(4.0, std::round(0.04 * layout.width))),
        font(std::max(10.0, std::round(layout.font * layout.width))),
        below(layout.titled || layout.letters ? 2.2 * font + 0.5 * gap : gap) {}
  double width, gap, font;
  double below;  // from the bottom of a cell to the top of the next below
};

// The upper edges of the rows of a sheet, and its height without a legend.
struct Rows {
  std::vector<double> tops, heights;
  double bottom = 0.0;
};

Rows rows_of(const std::vector<PictureSize>& sizes, const SheetLayout& layout, int columns) {
  const Measures cell(layout);
  Rows rows;
  rows.bottom = cell.gap;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const double shape = static_cast<double>(sizes[k].height) / std::max(1, sizes[k].width);
    const double height = std::round(std::min(shape, layout.tallest) * cell.width);
    if (k % static_cast<std::size_t>(columns) == 0) rows.heights.push_back(0.0);
    rows.heights.back() = std::max(rows.heights.back(), height);
  }
  for (const double height : rows.heights) {
    rows.tops.push_back(rows.bottom);
    rows.bottom += height + cell.below;
  }
  return rows;
}

CairoSurface read(const std::filesystem::path& file) {
  CairoSurface surface(cairo_image_surface_create_from_png(file.c_str()), cairo_surface_destroy);
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::files, fmt::format("cannot read the picture '{}': {}", file.string(),
                                              cairo_status_to_string(status)));
  return surface;
}

// Draws the picture in the middle of the cell with its upper left corner at x, y.
void draw_picture(Canvas& canvas, const Measures& cell, double x, double y, double cell_height,
                  cairo_surface_t* from) {
  const double width = cairo_image_surface_get_width(from);
  const double height = cairo_image_surface_get_height(from);
  const double scale = std::min(cell.width / width, cell_height / height);
  canvas.picture(from, x + 0.5 * (cell.width - scale * width),
                 y + 0.5 * (cell_height - scale * height), scale);
}

// Returns "(a)", after "(z)" "(aa)".
std::string letter_of(std::size_t k) {
  constexpr std::size_t count = 26;
  std::string letters;
  for (std::size_t left = k + 1; left > 0; left = (left - 1) / count)
    letters.insert(letters.begin(), static_cast<char>('a' + (left - 1) % count));
  return "(" + letters + ")";
}

// Writes the title below the middle of a cell.
void draw_title(Canvas& canvas, const Font& font, const Measures& cell, double x, double bottom,
                const std::string& title, Colour colour) {
  const std::string text = font.fitting(title, cell.font, cell.width);
  canvas.write(font, font.place(text, x + 0.5 * cell.width, bottom + 1.4 * cell.font, cell.font,
                                0.5, colour));
}

Image blank(int width, double height, bool even) {
  if (width > max_of_sheet || height > max_of_sheet)
    throw Error(ErrorKind::refused,
                fmt::format("contact_sheet: the sheet would be {} x {:.0f} px, more than {}", width,
                            height, max_of_sheet),
                "give a smaller width or fewer pictures");
  const int odd = even ? 1 : 0, h = static_cast<int>(height);
  return {width, h + (h & odd)};
}

// Draws a sheet of pictures of these sizes; picture(k) is the surface of each and title(k) its
// text.
template <class Picture, class Title>
Image sheet_of(const std::vector<PictureSize>& sizes, const SheetLayout& layout,
               const Image& legend, Picture picture, Title title) {
  if (sizes.empty()) throw Error(ErrorKind::refused, "contact_sheet: there is no picture");
  const int columns = std::min(layout.columns, static_cast<int>(sizes.size()));
  const Measures cell(layout);
  const Rows rows = rows_of(sizes, layout, columns);
  const int width = sheet_width(static_cast<int>(sizes.size()), layout);
  Image sheet = blank(width, rows.bottom + legend.height, layout.even);
  const Font font;
  const Theme& theme = theme_of(ground_of(layout.look));
  Canvas canvas(sheet);
  canvas.colour(theme.background);
  canvas.fill(0, 0, sheet.width, sheet.height);
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    throw_if_interrupted();
    const std::size_t column = k % static_cast<std::size_t>(columns);
    const std::size_t row = k / static_cast<std::size_t>(columns);
    const double x = cell.gap + static_cast<double>(column) * (cell.width + cell.gap);
    draw_picture(canvas, cell, x, rows.tops[row], rows.heights[row], picture(k).get());
    const std::string letter = layout.letters ? letter_of(k) + " " : "";
    draw_title(canvas, font, cell, x, rows.tops[row] + rows.heights[row], letter + title(k),
               theme.text);
  }
  canvas.copy(legend, {0, 0, legend.width, legend.height}, 0, static_cast<int>(rows.bottom));
  return sheet;
}

}  // namespace

int sheet_width(int count, const SheetLayout& layout) {
  const Measures cell(layout);
  const int columns = std::min(layout.columns, count);
  const int width = static_cast<int>(columns * (cell.width + cell.gap) + cell.gap);
  return width + (layout.even ? width % 2 : 0);
}

Image contact_sheet(const std::vector<SheetPicture>& pictures, const SheetLayout& layout) {
  std::vector<PictureSize> sizes;
  sizes.reserve(pictures.size());
  for (const SheetPicture& picture : pictures) sizes.push_back(size_of_png(picture.file));
  return sheet_of(
      sizes, layout, {}, [&](std::size_t k) { return read(pictures[k].file); },
      [&](std::size_t k) { return pictures[k].title; });
}

Image contact_sheet(std::vector<SheetImage>& images, const SheetLayout& layout,
                    const Image& legend) {
  std::vector<PictureSize> sizes;
  sizes.reserve(images.size());
  for (const SheetImage& one : images) sizes.push_back({one.image.width, one.image.height});
  return sheet_of(
      sizes, layout, legend,
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
