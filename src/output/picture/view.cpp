// SPDX-License-Identifier: MIT
#include "output/picture/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.hpp"
#include "measure/cracks.hpp"
#include "measure/field.hpp"
#include "render/bond_drawing.hpp"

namespace hackle {
namespace {

std::string place_text(const Vec2& place) {
  return fmt::format("{{{}, {}}}", quantity(place.x(), "m"), quantity(place.y(), "m"));
}

// Returns half the size of the lattice and of the window described by Zoom, m.
Vec2 half_size(const Grid& grid) {
  return 0.5 * grid.dx * Vec2(grid.nx, grid.ny);
}
Vec2 half_size(const Zoom& zoom, const Grid& grid) {
  return zoom.half_width * Vec2(1.0, static_cast<double>(grid.ny) / grid.nx);
}

constexpr double farthest_zoom = 10.0;  // half a width, in widths of the plate

void check(const char* output, const Zoom& zoom, const Grid& grid, Problems& problems) {
  const double max = farthest_zoom * grid.nx * grid.dx;
  if (!(zoom.half_width >= grid.dx && zoom.half_width <= max)) {
    problems.add(
        fmt::format("{}: half the width of zoom is {}, it must lie between {} and {}", output,
                    quantity(zoom.half_width, "m"), quantity(grid.dx, "m"), quantity(max, "m")),
        "the spacing of nodes, and ten widths of the plate");
    return;
  }
  const Vec2 half = half_size(grid), reach = half + half_size(zoom, grid);
  // Written so that nan counts as out of reach.
  if (((zoom.centre - grid.centre).array().abs() < reach.array()).all()) return;
  problems.add(fmt::format("{}: zoom shows nothing of the plate, its middle is {}", output,
                           place_text(zoom.centre)),
               fmt::format("the plate reaches from {} to {}", place_text(grid.centre - half),
                           place_text(grid.centre + half)));
}

Window window_of(const Zoom& zoom, const Grid& grid) {
  const Vec2 size = 2.0 / grid.dx * half_size(zoom, grid);
  Window window;
  window.nx = std::max(1, static_cast<int>(std::lround(size.x())));
  window.ny = std::max(1, static_cast<int>(std::lround(size.y())));
  return window;
}

// Moves the centre of the window as near to the point, m, as whole cells allow, but not so far that
// cells could not be counted.
Window moved(Window window, const Vec2& middle, const Grid& grid) {
  constexpr double farthest = 1e8;
  const Vec2 corner =
      (grid.from_centre(middle) + 0.5 * Vec2(grid.nx - window.nx, grid.ny - window.ny))
          .cwiseMax(-farthest)
          .cwiseMin(farthest);
  window.left = static_cast<int>(std::lround(corner.x()));
  window.bottom = static_cast<int>(std::lround(corner.y()));
  return window;
}

// Returns the largest expected displacement of a breaking plate, m.
double usual_displacement(const View& view) {
  return scalar_of("displacement").ends(view).max;
}

constexpr double most_margin = 5.0;  // in sides of the plate

// Returns the margin in cells for a displaced plate. Fragments keep moving: by 32 us the edges of
// the paper's first plate have moved 11.5 times as far as usual.
int margin_of(const PictureOptions& options, const View& view) {
  constexpr double flight = 12.0;
  const Grid& grid = view.lattice().grid;
  const double reach =
      flight * magnification_of(options, view) * usual_displacement(view) / grid.dx;
  return static_cast<int>(std::ceil(std::min(reach, 0.5 * std::min(grid.nx, grid.ny))));
}

// Returns how many cells a whole window turned by `rotation` (rad) must be wider on each side, so
// that it contains this point, in cells from the centre of the lattice; 0 or less if it does.
double outside_by(const Grid& grid, double rotation, const Vec2& cells) {
  const double c = std::cos(rotation), s = std::sin(rotation);
  const Vec2 turned(c * cells.x() - s * cells.y(), s * cells.x() + c * cells.y());
  const Vec2 half = 0.5 * turned_size({grid.nx, grid.ny}, rotation);
  return (turned.cwiseAbs() - half).maxCoeff();
}

// Returns the margin in cells that the plate needs as it is displaced now. Nodes without any bond,
// which may fly far, do not count.
int needed_margin(const PictureOptions& options, const View& view) {
  const double times = magnification_of(options, view);
  const Grid& grid = view.lattice().grid;
  if (times == 0.0) return 0;
  const std::vector<float> lost = damage(view).values;
  double most = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (view.lattice().is_void(i, j) || lost[grid.index(i, j)] == 1.0F) continue;
      const Vec2 place = grid.from_centre(i, j) + times / grid.dx * view.displacement(i, j);
      // Half a cell lies around the node.
      most = std::max(most, outside_by(grid, options.rotation, place) + std::numbers::sqrt2 / 2.0);
    }
  const double max = most_margin * std::max(grid.nx, grid.ny);
  return static_cast<int>(std::ceil(std::min(most, max)));
}

double nodes_seen(const PictureOptions& options, const Grid& grid) {
  if (!options.zoom) return static_cast<double>(grid.nodes());
  const Window window = window_of(*options.zoom, grid);
  return static_cast<double>(window.nx) * window.ny;
}

Vec2 direction_of(Toward toward) {
  constexpr std::array<std::array<double, 2>, enum_names<Toward>.size()> directions{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const auto& [x, y] = directions[static_cast<std::size_t>(toward)];
  return {x, y};
}

}  // namespace

void check_view(const char* output, const PictureOptions& options, const Grid& grid,
                Problems& problems) {
  if (options.zoom) check(output, *options.zoom, grid, problems);
  if (options.bonds && nodes_seen(options, grid) > max_drawn_nodes)
    problems.add(fmt::format("{}: bonds of {:.0f} nodes would be drawn, {} are the most", output,
                             nodes_seen(options, grid), max_drawn_nodes),
                 "zoom = {x, y, half} looks at a part of the plate");
  if (options.follow && !options.zoom)
    problems.add(fmt::format("{}: follow needs a zoom", output),
                 "zoom = {x, y, half} says where to begin, and how much is seen");
}

double magnification_of(const PictureOptions& options, const View& view) {
  if (!options.deformed) return 0.0;
  if (options.magnification) return *options.magnification;
  constexpr double share = 0.01;
  const Plate& plate = view.plate();
  return neat_at_most(share * std::min(plate.width, plate.height) / usual_displacement(view));
}

Window window_of(const PictureOptions& options, const View& view) {
  const Grid& grid = view.lattice().grid;
  if (options.zoom) return moved(window_of(*options.zoom, grid), options.zoom->centre, grid);
  return whole_window(grid, options.rotation,
                      std::max(margin_of(options, view), needed_margin(options, view)));
}

Window followed(Window window, const PictureOptions& options, const View& view) {
  if (!options.follow) return window;
  const Grid& grid = view.lattice().grid;
  const auto tip = foremost(damage(view), grid, direction_of(*options.follow));
  if (!tip) return window;
  const Vec2 node = grid.from_centre(*tip) + 0.5 * Vec2(grid.nx - 1, grid.ny - 1);
  const Vec2 moved_by = magnification_of(options, view) *
                        view.displacement(std::clamp(static_cast<int>(node.x()), 0, grid.nx - 1),
                                          std::clamp(static_cast<int>(node.y()), 0, grid.ny - 1));
  return moved(window, *tip + moved_by, grid);
}

}  // namespace hackle
