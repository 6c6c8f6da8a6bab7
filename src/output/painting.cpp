// SPDX-License-Identifier: MIT
#include "output/painting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "measure/links.hpp"
#include "output/view.hpp"
#include "render/colour_map.hpp"

namespace hackle {
namespace {

constexpr int least_width = 320, most_width = 7680;  // px

bool is_fringes(const PictureOptions& options) {
  return options.field == fringes_name;
}

bool is_logarithmic(const PictureOptions& options) {
  return options.logarithmic.value_or(scalar_of(options.field).logarithmic);
}

// What suits the field; a logarithmic scale of four decades where it has none of its own.
Ends ends_of(const Scalar& scalar, const PictureOptions& options, const Simulation& simulation) {
  Ends ends = scalar.ends(simulation);
  if (is_fringes(options)) ends.most *= options.thickness;
  if (is_logarithmic(options) && !(ends.least > 0.0)) ends.least = 1e-4 * ends.most;
  return ends;
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

std::vector<std::uint8_t> in_255ths(const std::vector<float>& shares) {
  std::vector<std::uint8_t> bytes(shares.size());
  std::ranges::transform(shares, bytes.begin(), [](float share) {
    return static_cast<std::uint8_t>(std::lround(255.0F * share));
  });
  return bytes;
}

}  // namespace

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
  check_view(output, options, grid, problems);
  problems.throw_if_any();
  if (options.range) check_range(output, options, problems);
  problems.throw_if_any();
}

PictureStyle style_of(const PictureOptions& options, const Simulation& simulation) {
  const Scalar& scalar = scalar_of(options.field);
  PictureStyle style;
  style.grid = simulation.lattice().grid;
  style.window = window_of(options, simulation);
  style.rotation = options.rotation;
  style.magnification = magnification_of(options, simulation);
  style.background = options.background;
  style.width = options.width;
  style.title = simulation.plate().material.name;
  style.colour_map = options.colours.empty() ? std::string(scalar.colours) : options.colours;
  const Ends ends = options.range.value_or(ends_of(scalar, options, simulation));
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

int widest_picture(const PictureOptions& options, const Simulation& simulation,
                   const Extent& most) {
  const Grid seen = part(simulation.lattice().grid, window_of(options, simulation));
  for (int width = std::min(most.width, most_width) / 2 * 2; width >= least_width; width -= 2)
    if (make_layout(seen, width).height <= most.height) return width;
  return 0;
}

Shot shot_of(const PictureOptions& options, const Simulation& simulation) {
  Shot shot;
  shot.values = scalar_of(options.field).values(simulation);
  shot.time = simulation.time();
  shot.discs = impactors(simulation);
  if (is_fringes(options))
    for (float& order : shot.values) order *= static_cast<float>(options.thickness);
  if (options.cracks && options.field != "damage") shot.gaps = in_255ths(damage(simulation).values);
  if (magnification_of(options, simulation) > 0.0) {
    shot.displacement = displacement(simulation).values;
    shot.links = links(simulation);
  }
  if (options.follow) shot.window = followed(window_of(options, simulation), options, simulation);
  // Pictures show the background where a value is no number.
  const std::vector<std::uint8_t>& material = simulation.lattice().material;
  for (std::size_t node = 0; node < material.size(); ++node)
    if (material[node] == Lattice::void_node)
      shot.values[node] = std::numeric_limits<float>::quiet_NaN();
  return shot;
}

}  // namespace hackle
