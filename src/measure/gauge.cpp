// SPDX-License-Identifier: MIT
#include "measure/gauge.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "lattice/carve.hpp"
#include "measure/between_nodes.hpp"
#include "measure/node_value.hpp"

namespace hackle {
namespace {

const NodeQuantity& quantity_of(const Gauge& gauge) {
  return *std::ranges::find(node_quantities(), gauge.of, &NodeQuantity::name);
}

bool reads_a_quantity(const Gauge& gauge) {
  return gauge.kind == Gauge::Kind::point || gauge.kind == Gauge::Kind::line ||
         gauge.kind == Gauge::Kind::region;
}

std::optional<double> value_at(const Gauge& gauge, const View& view, const Vec2& place) {
  const auto nodes = surrounding(view, place);
  if (!nodes) return std::nullopt;
  return interpolated(*nodes, [&](int i, int j) { return quantity_of(gauge).value(view, i, j); });
}

std::optional<Vec2> displacement_at(const View& view, const Vec2& place) {
  const auto nodes = surrounding(view, place);
  if (!nodes) return std::nullopt;
  return interpolated(*nodes, [&](int i, int j) { return view.displacement(i, j); });
}

// Midpoints of equal parts, without those in holes.
std::optional<double> along_line(const Gauge& gauge, const View& view) {
  constexpr double parts_a_spacing = 2.0, max_parts = 1e5;
  const double length = (gauge.to - gauge.from).norm();
  const int parts = static_cast<int>(
      std::clamp(std::ceil(parts_a_spacing * length / view.lattice().grid.dx), 1.0, max_parts));
  double sum = 0.0;
  int found = 0;
  for (int k = 0; k < parts; ++k) {
    const double share = (k + 0.5) / parts;
    const auto value = value_at(gauge, view, gauge.from + share * (gauge.to - gauge.from));
    sum += value.value_or(0.0);
    found += value ? 1 : 0;
  }
  return found > 0 ? std::optional(sum / found) : std::nullopt;
}

std::optional<double> over_region(const Gauge& gauge, const View& view) {
  const Lattice& lattice = view.lattice();
  double sum = 0.0, count = 0.0;
  for_nodes_in(gauge.area, lattice.grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    sum += quantity_of(gauge).value(view, i, j);
    count += 1.0;
  });
  return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

// Without cancellation: |L + d| - L = (2 L.d + d.d)/(|L + d| + |L|).
double growth(const Vec2& line, const Vec2& moved) {
  return moved.dot(2.0 * line + moved) / ((line + moved).norm() + line.norm());
}

std::optional<double> between(const Gauge& gauge, const View& view) {
  const auto one = displacement_at(view, gauge.from), other = displacement_at(view, gauge.to);
  if (!one || !other) return std::nullopt;
  const Vec2 line = gauge.to - gauge.from, moved = *other - *one, along = line.normalized();
  switch (gauge.kind) {
    case Gauge::Kind::extension:
      return growth(line, moved);
    case Gauge::Kind::strain:
      return growth(line, moved) / line.norm();
    case Gauge::Kind::opening:
      return moved.dot(along);
    default:
      return moved.dot(Vec2(-along.y(), along.x()));
  }
}

}  // namespace

std::optional<double> reading(const Gauge& gauge, const View& view) {
  switch (gauge.kind) {
    case Gauge::Kind::point:
      return value_at(gauge, view, gauge.from);
    case Gauge::Kind::line:
      return along_line(gauge, view);
    case Gauge::Kind::region:
      return over_region(gauge, view);
    default:
      return between(gauge, view);
  }
}

std::string_view unit_of(const Gauge& gauge) {
  if (reads_a_quantity(gauge)) return quantity_of(gauge).unit;
  return gauge.kind == Gauge::Kind::strain ? "" : "m";
}

void check_on(const Gauge& gauge, const View& view, const std::string& who) {
  if (reading(gauge, view)) return;
  throw Error(ErrorKind::refused,
              fmt::format("{}: the gauge {} lies off the plate, or in a hole", who, gauge.name),
              fmt::format("the plate goes from the origin, its lower left corner, to ({}, {})",
                          quantity(view.plate().width, "m"), quantity(view.plate().height, "m")));
}

Column column_of(const Gauge& gauge) {
  return {gauge.name, std::string(unit_of(gauge)),
          [gauge](Glance& glance) { return reading(gauge, glance.view()); }};
}

}  // namespace hackle
