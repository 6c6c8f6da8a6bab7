// SPDX-License-Identifier: MIT
#include "render/layout.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

int even(double value) {
  return 2 * static_cast<int>(std::ceil(value / 2.0));
}

// Pixels of a cell along x and y.
double cell_size(const Grid& grid, double width, double height) {
  const double size = std::min(width / grid.nx, height / grid.ny);
  return size >= 3.0 ? std::floor(size) : size;
}

}  // namespace

Grid part(const Grid& grid, const Window& window) {
  const Vec2 corner(window.left - 0.5 * grid.nx, window.bottom - 0.5 * grid.ny);
  const Vec2 middle = corner + 0.5 * Vec2(window.nx, window.ny);
  return {window.nx, window.ny, grid.dx, grid.centre + grid.dx * middle};
}

double label_ems(const std::string& name) {
  constexpr double letter = 0.6, behind = 1.0;
  return std::max(shortest_label, letter * static_cast<double>(name.size()) + behind);
}

Layout make_layout(const Grid& grid, int width, double label) {
  Layout layout;
  layout.width = width;
  layout.font = std::max(10.0, std::round(0.0175 * width));
  layout.small_font = std::max(9.0, std::round(0.8 * layout.font));
  const int margin = static_cast<int>(std::round(1.5 * layout.font));
  const int inner = width - 2 * margin;

  const double cell = cell_size(grid, inner, width);
  const int plate_width = std::max(1, static_cast<int>(std::lround(cell * grid.nx)));
  const int plate_height = std::max(1, static_cast<int>(std::lround(cell * grid.ny)));
  // Captions and legend are flush with the plate, unless it is too narrow for them.
  const int side = plate_width > inner * 9 / 10 ? (width - plate_width) / 2 : margin;
  layout.caption = {side, margin * 2 / 3, width - 2 * side,
                    static_cast<int>(std::ceil(1.3 * layout.font))};
  layout.plate = {(width - plate_width) / 2, layout.caption.bottom() + margin / 3, plate_width,
                  plate_height};

  // The legend: the name of the field, the bar, then its ticks below.
  const int legend = layout.plate.bottom() + margin * 5 / 6;
  const int bar_x = side + static_cast<int>(std::ceil(label * layout.font));
  const int bar_height = static_cast<int>(std::round(0.8 * layout.font));
  layout.bar = {bar_x, legend, static_cast<int>(0.28 * width), bar_height};
  const int legend_height =
      bar_height + static_cast<int>(std::ceil(0.4 * layout.font + 1.3 * layout.small_font));
  const int scale_x = layout.bar.right() + 3 * margin / 2;
  layout.scale = {scale_x, legend, width - side - scale_x, legend_height};
  layout.height = even(legend + legend_height + 0.6 * margin);
  return layout;
}

Layout bare_layout(int width, int height) {
  Layout layout;
  layout.width = width;
  layout.height = height;
  layout.caption = {0, 0, width, 0};
  layout.plate = {0, 0, width, height};
  layout.bar = layout.scale = {0, height, width, 0};
  return layout;
}

double neat_at_most(double most) {
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
    if (factor * decade <= most * (1.0 + 1e-12)) return factor * decade;
  return decade;
}

}  // namespace hackle
