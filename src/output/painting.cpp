// SPDX-License-Identifier: MIT
#include "output/painting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "output/automatic_range.hpp"
#include "render/colour_map.hpp"

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

bool is_fringes(const PictureOptions& options) {
  return options.field == fringes_name;
}

void check_range(const char* output, const PictureOptions& options, Problems& problems) {
  const auto [least, most] = *options.range;
  if (!(std::isfinite(least) && std::isfinite(most) && least < most))
    problems.add(fmt::format("{}: range is {{{}, {}}}, it must go from a smaller to a larger value",
                             output, least, most));
  else if (is_logarithmic(options) && least <= 0.0)
    problems.add(fmt::format("{}: range begins at {}, on a logarithmic scale it must be above 0",
                             output, least));
}

void check_percentile(const char* output, const PictureOptions& options, Problems& problems) {
  if (!(*options.percentile >= 50.0 && *options.percentile <= 100.0))
    problems.add(fmt::format("{}: percentile is {}, it must lie between 50 and 100", output,
                             *options.percentile));
  if (options.range)
    problems.add(fmt::format("{}: range and percentile are given", output),
                 "range says where the colour bar ends, percentile lets the values say it");
}

// What the options say of it.
Ends ends_of(const PictureOptions& options, const Simulation& simulation) {
  if (options.range) return *options.range;
  if (options.percentile) return automatic_range(options, simulation);
  return usual_ends(options, simulation);
}

}  // namespace

bool is_logarithmic(const PictureOptions& options) {
  return options.logarithmic.value_or(scalar_of(options.field).logarithmic);
}

// What suits the field; a logarithmic scale of four decades where it has none of its own.
Ends usual_ends(const PictureOptions& options, const Simulation& simulation) {
  Ends ends = scalar_of(options.field).ends(simulation);
  if (is_fringes(options)) ends.most *= options.thickness;
  if (is_logarithmic(options) && !(ends.least > 0.0)) ends.least = 1e-4 * ends.most;
  return ends;
}

void refuse_percentile(const char* output, const PictureOptions& options) {
  if (options.percentile)
    throw Error(ErrorKind::refused,
                fmt::format("{}: percentile needs to know what will be seen", output),
                "give a range; or record the run, and let recording(...):movie{} find it");
}

void check(const char* output, const PictureOptions& options, const Grid& grid) {
  Problems problems;
  if (std::ranges::find(scalar_names, options.field) == scalar_names.end())
    problems.add(fmt::format("{}: there is no field '{}'{}", output, options.field,
                             did_you_mean(options.field, scalar_names)),
                 "one of " + comma_list(scalar_names));
  if (!options.colours.empty() &&
      std::ranges::find(colour_map_names, options.colours) == colour_map_names.end())
    problems.add(fmt::format("{}: there are no colours '{}'{}", output, options.colours,
                             did_you_mean(options.colours, colour_map_names)),
                 "one of " + comma_list(colour_map_names));
  if (options.width < least_width || options.width > most_width || options.width % 2 != 0)
    problems.add(fmt::format("{}: width is {} px, it must be even and between {} and {} px", output,
                             options.width, least_width, most_width));
  if (options.zoom) check(output, *options.zoom, grid, problems);
  problems.throw_if_any();
  if (options.range) check_range(output, options, problems);
  if (options.percentile) check_percentile(output, options, problems);
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
  const Scalar& scalar = scalar_of(options.field);
  PictureStyle style;
  style.grid = simulation.lattice().grid;
  style.window = window_of(options, style.grid);
  style.width = options.width;
  style.title = simulation.plate().material.name;
  style.colour_map = options.colours.empty() ? std::string(scalar.colours) : options.colours;
  const Ends ends = ends_of(options, simulation);
  style.least = ends.least;
  style.most = ends.most;
  style.logarithmic = is_logarithmic(options);
  style.sampling = scalar.sampling;
  style.label = scalar.label;
  style.unit = scalar.unit;
  if (is_fringes(options))
    style.title += fmt::format(", {} thick", quantity(options.thickness, "m"));
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
  return PlatePainter(style).paint(shot_of(options, simulation));
}

int widest_picture(const PictureOptions& options, const Grid& grid, const Extent& most) {
  const Grid seen = part(grid, window_of(options, grid));
  for (int width = std::min(most.width, most_width) / 2 * 2; width >= least_width; width -= 2)
    if (make_layout(seen, width).height <= most.height) return width;
  return 0;
}

Shot shot_of(const PictureOptions& options, const Simulation& simulation) {
  Shot shot{
      scalar_of(options.field).values(simulation), {}, simulation.time(), impactors(simulation)};
  if (is_fringes(options))
    for (float& order : shot.values) order *= static_cast<float>(options.thickness);
  if (options.cracks && options.field != "damage") shot.gaps = damage(simulation).values;
  // Pictures show the background where a value is no number.
  const std::vector<std::uint8_t>& material = simulation.lattice().material;
  for (std::size_t node = 0; node < material.size(); ++node)
    if (material[node] == Lattice::void_node)
      shot.values[node] = std::numeric_limits<float>::quiet_NaN();
  return shot;
}

}  // namespace hackle
