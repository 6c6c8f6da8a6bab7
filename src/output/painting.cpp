// SPDX-License-Identifier: MIT
#include "output/painting.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "base/text.hpp"

namespace hackle {
namespace {

constexpr int least_width = 320, most_width = 7680;  // px

}  // namespace

void check(const char* output, const PictureOptions& options) {
  Problems problems;
  if (std::ranges::find(field_names, options.field) == field_names.end())
    problems.add(fmt::format("{}: there is no field '{}'{}", output, options.field,
                             did_you_mean(options.field, field_names)),
                 "one of " + comma_list(field_names));
  if (options.width < least_width || options.width > most_width || options.width % 2 != 0)
    problems.add(fmt::format("{}: width is {} px, it must be even and between {} and {} px", output,
                             options.width, least_width, most_width));
  problems.throw_if_any();
}

PictureStyle style_of(const PictureOptions& options, const Simulation& simulation) {
  PictureStyle style;
  style.grid = simulation.lattice().grid;
  style.width = options.width;
  style.title = simulation.plate().material.name;
  // A straight crack has damage 0.4 to 0.5 on its sides: the whole map up to there, the rest
  // saturates.
  style.colour_map = "damage";
  style.least = 0.0;
  style.most = 0.5;
  return style;
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
