// SPDX-License-Identifier: MIT
#include "scene/plate.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

constexpr std::array<std::pair<std::string_view, Edge>, 4> edges{
    {{"left", Edge::left}, {"right", Edge::right}, {"bottom", Edge::bottom}, {"top", Edge::top}}};

std::string point_text(const Vec2& point) {
  return fmt::format("({}, {})", quantity(point.x(), "m"), quantity(point.y(), "m"));
}

std::string extent_text(const Plate& plate) {
  return fmt::format("the plate is {} x {}", quantity(plate.width, "m"),
                     quantity(plate.height, "m"));
}

bool on_plate(const Plate& plate, const Vec2& point) {
  // A rounding error of arithmetic such as 100*mm - 0.1 must not put a point off the plate.
  const double slack = 1e-9 * (plate.width + plate.height);
  return point.x() >= -slack && point.x() <= plate.width + slack && point.y() >= -slack &&
         point.y() <= plate.height + slack;
}

void check_size(const char* key, double value, Problems& problems) {
  if (std::isfinite(value) && value > 0.0) return;
  problems.add(fmt::format("plate: {} is {} m, it must be above 0 m", key, value));
}

std::string counted(std::size_t count, const char* noun) {
  return count == 0 ? std::string() : fmt::format(", {} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

std::string_view name_of(Edge edge) {
  for (const auto& [name, value] : edges)
    if (value == edge) return name;
  return "?";
}

std::optional<Edge> edge_named(std::string_view name) {
  for (const auto& [known, value] : edges)
    if (known == name) return value;
  return std::nullopt;
}

NoFail strip(const Plate& plate, Edge edge, double depth) {
  NoFail zone{{0.0, 0.0}, {plate.width, plate.height}};
  switch (edge) {
    case Edge::left:
      zone.most.x() = depth;
      break;
    case Edge::right:
      zone.least.x() = plate.width - depth;
      break;
    case Edge::bottom:
      zone.most.y() = depth;
      break;
    case Edge::top:
      zone.least.y() = plate.height - depth;
      break;
  }
  return zone;
}

void check(const Plate& plate, Problems& problems) {
  check_size("width", plate.width, problems);
  check_size("height", plate.height, problems);
  check(plate.material, problems);
  for (const Crack& crack : plate.cracks) check(plate, crack, problems);
  for (const Traction& traction : plate.tractions) check(traction, problems);
  for (const NoFail& zone : plate.no_fail) check(plate, zone, problems);
}

void check(const Plate& plate, const Crack& crack, Problems& problems) {
  const auto check_end = [&](const char* key, const Vec2& end) {
    if (on_plate(plate, end)) return;
    problems.add(fmt::format("crack: '{}' {} lies outside the plate", key, point_text(end)),
                 extent_text(plate) + ", origin at its lower left corner");
  };
  check_end("from", crack.from);
  check_end("to", crack.to);
  if (crack.from == crack.to)
    problems.add("crack: 'from' and 'to' are the same point", "give the two ends of the crack");
}

void check(const Traction& traction, Problems& problems) {
  if (traction.stress.allFinite()) return;
  problems.add(fmt::format("traction: stress on the {} edge is {{{}, {}}} Pa, it must be finite",
                           name_of(traction.edge), traction.stress.x(), traction.stress.y()));
}

void check(const Plate& plate, const NoFail& zone, Problems& problems) {
  if (!(zone.least.x() <= zone.most.x() && zone.least.y() <= zone.most.y()))
    problems.add("nofail: 'from' must be the lower left and 'to' the upper right corner");
  const bool apart = zone.most.x() < 0.0 || zone.most.y() < 0.0 || zone.least.x() > plate.width ||
                     zone.least.y() > plate.height;
  if (apart)
    problems.add(fmt::format("nofail: the zone from {} to {} lies outside the plate",
                             point_text(zone.least), point_text(zone.most)),
                 extent_text(plate));
}

std::string describe(const Plate& plate) {
  return fmt::format("plate {} x {} mm, {}{}{}{}{}", shortest(std::round(plate.width * 1e9) * 1e-6),
                     shortest(std::round(plate.height * 1e9) * 1e-6),
                     plate.plane == Plane::strain ? "plane strain, " : "", describe(plate.material),
                     counted(plate.cracks.size(), "crack"),
                     counted(plate.tractions.size(), "traction"),
                     counted(plate.no_fail.size(), "no-fail zone"));
}

}  // namespace hackle
