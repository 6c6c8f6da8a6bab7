// SPDX-License-Identifier: MIT
#include "output/picture/field_choice.hpp"

#include <limits>
#include <string_view>

#include "measure/averages.hpp"

namespace hackle {

FieldChoice first_field(const PictureOptions& options) {
  const Scalar& scalar = scalar_of(options.field);
  const bool logarithmic = options.scale ? *options.scale == Scale::log : scalar.logarithmic;
  const std::string_view usual = colours_for(options.look, scalar.colours);
  const std::string colours = options.colours.empty() ? std::string(usual) : options.colours;
  return {scalar, options.range, colours, logarithmic, options.thickness, options.average};
}

FieldChoice second_field(const PictureOptions& options) {
  const Scalar& scalar = scalar_of(*options.second);
  const std::string colours(colours_for(options.look, scalar.colours));
  return {scalar,         options.second_range, colours, scalar.logarithmic, options.thickness,
          options.average};
}

Ends usual_ends(const FieldChoice& field, const View& view) {
  Ends ends = field.scalar.ends(view);
  if (field.is_fringes()) ends.max *= field.thickness;
  if (field.logarithmic && !(ends.min > 0.0)) ends.min = 1e-4 * ends.max;
  return ends;
}

namespace {

// The stresses are averaged, not their fringes: those of short waves do not cancel.
std::vector<float> averaged_values(const FieldChoice& field, const View& view) {
  if (!field.average) return field.scalar.values(view);
  if (field.is_fringes()) return fringes_of(view, averaged(view, stresses(view)));
  return averaged(view, field.scalar.values(view));
}

}  // namespace

std::vector<float> values_of(const FieldChoice& field, const View& view) {
  std::vector<float> values = averaged_values(field, view);
  if (field.is_fringes())
    for (float& order : values) order *= static_cast<float>(field.thickness);
  const std::vector<std::uint8_t>& material = view.lattice().material;
  for (std::size_t node = 0; node < material.size(); ++node)
    if (material[node] == Lattice::void_node)
      values[node] = std::numeric_limits<float>::quiet_NaN();
  return values;
}

bool is_logarithmic(const PictureOptions& options) {
  return first_field(options).logarithmic;
}

Ends usual_ends(const PictureOptions& options, const View& view) {
  return usual_ends(first_field(options), view);
}

std::vector<float> field_values(const PictureOptions& options, const View& view) {
  return values_of(first_field(options), view);
}

}  // namespace hackle
