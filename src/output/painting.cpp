// SPDX-License-Identifier: MIT
#include "output/painting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

constexpr int least_width = 320, most_width = 7680;  // px

std::string place_text(const Vec2& place) {
  return fmt::format("{{{}, {}}}", quantity(place.x(), "m"), quantity(place.y(), "m"));
}

// Half the size of the lattice and of the window that Zoom describes, m.
Vec2 half_size(const Grid& grid) {
  return 0.5 * grid.dx * Vec2(grid.nx, grid.ny);
}
Vec2 half_size(const Zoom& zoom, const Grid& grid) {
  return zoom.half_width * Vec2(1.0, static_cast<double>(grid.ny) / grid.nx);
}

void check(const char* output, const Zoom& zoom, const Grid& grid, Problems& problems) {
  const double most = grid.nx * grid.dx;
  if (!(zoom.half_width >= grid.dx && zoom.half_width <= most)) {
    problems.add(
        fmt::format("{}: half the width of zoom is {}, it must lie between {} and {}", output,
                    quantity(zoom.half_width, "m"), quantity(grid.dx, "m"), quantity(most, "m")),
        "the spacing of nodes, and the width of the plate");
    return;
  }
  const Vec2 half = half_size(grid), reach = half + half_size(zoom, grid);
  // Written so that nan is out of reach.
  if (((zoom.centre - grid.centre).array().abs() < reach.array()).all()) return;
  problems.add(fmt::format("{}: zoom shows nothing of the plate, its middle is {}", output,
                           place_text(zoom.centre)),
               fmt::format("the plate reaches from {} to {}", place_text(grid.centre - half),
                           place_text(grid.centre + half)));
}

}  // namespace

void check(const char* output, const PictureOptions& options, const Grid& grid) {
  Problems problems;
  if (std::ranges::find(field_names, options.field) == field_names.end())
    problems.add(fmt::format("{}: there is no field '{}'{}", output, options.field,
                             did_you_mean(options.field, field_names)),
                 "one of " + comma_list(field_names));
  if (options.width < least_width || options.width > most_width || options.width % 2 != 0)
    problems.add(fmt::format("{}: width is {} px, it must be even and between {} and {} px", output,
                             options.width, least_width, most_width));
  if (options.zoom) check(output, *options.zoom, grid, problems);
  problems.throw_if_any();
}

Window window_of(const PictureOptions& options, const Grid& grid) {
  Window window{0, 0, grid.nx, grid.ny};
  if (!options.zoom) return window;
  const Vec2 size = 2.0 / grid.dx * half_size(*options.zoom, grid);
  window.nx = std::max(1, static_cast<int>(std::lround(size.x())));
  window.ny = std::max(1, static_cast<int>(std::lround(size.y())));
  const Vec2 corner =
      grid.from_centre(options.zoom->centre) + 0.5 * Vec2(grid.nx - window.nx, grid.ny - window.ny);
  window.left = static_cast<int>(std::lround(corner.x()));
  window.bottom = static_cast<int>(std::lround(corner.y()));
  return window;
}

PictureStyle style_of(const PictureOptions& options, const Simulation& simulation) {
  PictureStyle style;
  style.grid = simulation.lattice().grid;
  style.window = window_of(options, style.grid);
  style.width = options.width;
  style.title = simulation.plate().material.name;
  // A straight crack has damage 0.4 to 0.5 on its sides: the whole map up to there, the rest
  // saturates.
  style.colour_map = "damage";
  style.least = 0.0;
  style.most = 0.5;
  return style;
}

Image paint(const Simulation& simulation, const PictureOptions& options,
            const std::optional<Extent>& bare) {
  simulation.check_finite();
  PictureStyle style = style_of(options, simulation);
  if (bare) {
    style.width = bare->width;
    style.bare_height = bare->height;
  }
  return PlatePainter(style).paint(field_of(options.field, simulation), simulation.time(),
                                   impactors(simulation));
}

int widest_picture(const PictureOptions& options, const Grid& grid, const Extent& most) {
  const Grid seen = part(grid, window_of(options, grid));
  for (int width = std::min(most.width, most_width) / 2 * 2; width >= least_width; width -= 2)
    if (make_layout(seen, width).height <= most.height) return width;
  return 0;
}

// Pictures show the background where a value is no number.
Field field_of(const std::string&, const Simulation& simulation) {
  Field field = damage(simulation);
  const std::vector<std::uint8_t>& material = simulation.lattice().material;
  for (std::size_t node = 0; node < material.size(); ++node)
    if (material[node] == Lattice::void_node)
      field.values[node] = std::numeric_limits<float>::quiet_NaN();
  return field;
}

}  // namespace hackle
