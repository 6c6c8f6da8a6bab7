// SPDX-License-Identifier: MIT
#include "render/style_text.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

// The unit of the colour bar, with the prefix that suits its larger end.
PrefixedUnit unit_of(const FieldStyle& field) {
  return prefixed(std::max(std::abs(field.min), std::abs(field.max)), field.unit);
}

std::string bar_label(const FieldStyle& field) {
  return field.unit.empty()
             ? field.label
             : fmt::format("{} ({})", field.label, printed_unit(unit_of(field).name));
}

BarText bar_of(const FieldStyle& field) {
  const double unit = unit_of(field).factor;
  return {bar_label(field), field.min / unit, field.max / unit, field.logarithmic, field.whole, ""};
}

}  // namespace

OverlayText overlay_text_of(const PictureStyle& style) {
  OverlayText text;
  text.parts = style.overlay;
  text.title = style.title;
  text.note = style.note;
  text.slow_motion = style.slow_motion;
  text.bars = {bar_of(style.field)};
  if (style.second) text.bars.push_back(bar_of(*style.second));
  text.background = style.background;
  text.font = style.font;
  return text;
}

ColourMap colour_map_of(const FieldStyle& field) {
  if (field.colour_map == fringes_name) return fringe_map(field.min, field.max);
  return load_colour_map(field.colour_map);
}

std::vector<ColourMap> colour_maps_of(const PictureStyle& style) {
  std::vector<ColourMap> maps{colour_map_of(style.field)};
  if (style.second) maps.push_back(colour_map_of(*style.second));
  return maps;
}

}  // namespace hackle
