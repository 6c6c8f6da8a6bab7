// SPDX-License-Identifier: MIT
// What an experimenter puts on a plate: it reads one number.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "measure/quantity.hpp"
#include "scene/shape.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// Places are those of the undeformed plate, in m, and move with it.
struct Gauge {
  enum class Kind {
    point,      // a quantity at a place
    line,       // its mean along a line
    region,     // its mean over the nodes of an area
    extension,  // how much two places moved apart, m: an extensometer
    strain,     // the same over their first distance: a strain gauge
    opening,    // how far `to` moved from `from` along the line between them, m: CMOD, CTOD
    sliding     // likewise across it, to the left of the line
  };
  Kind kind = Kind::point;
  std::string of = "uy";  // of point, line, region
  Vec2 from{0, 0};        // the place of a point
  Vec2 to{0, 0};
  Region area;  // of a region
  std::string name;
};

template <>
inline constexpr auto enum_names<Gauge::Kind> = std::to_array<std::string_view>(
    {"point", "line", "region", "extension", "strain", "opening", "sliding"});

// Returns what it reads, in SI; nothing where it lies off the plate or in a hole. Between nodes
// values are interpolated (between_nodes.hpp); a line takes its mean from two places a spacing.
std::optional<double> reading(const Gauge& gauge, const View& view);
std::string_view unit_of(const Gauge& gauge);

// Throws Error (refused), in the name of `who`, where it cannot read anything on this plate.
void check_on(const Gauge& gauge, const View& view, const std::string& who);

Column column_of(const Gauge& gauge);

}  // namespace hackle
