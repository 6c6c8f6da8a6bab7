// SPDX-License-Identifier: MIT
#include "scene/plate.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "scene/check_members.hpp"
#include "scene/load_names.hpp"

namespace hackle {
namespace {

std::string point_text(const Vec2& point) {
  return fmt::format("({}, {})", quantity(point.x(), "m"), quantity(point.y(), "m"));
}

std::string extent_text(const Plate& plate) {
  return fmt::format("the plate is {} x {}", quantity(plate.width, "m"),
                     quantity(plate.height, "m"));
}

bool on_plate(const Plate& plate, const Vec2& point) {
  // Rounding errors of expressions such as 100*mm - 0.1 must not put a point off the plate.
  const double slack = 1e-9 * (plate.width + plate.height);
  return point.x() >= -slack && point.x() <= plate.width + slack && point.y() >= -slack &&
         point.y() <= plate.height + slack;
}

using Names = std::vector<std::string_view>;

template <class Nouns>
void add_names(const Nouns& nouns, Names& names) {
  for (const auto& noun : nouns)
    if (!noun.name.empty()) names.push_back(noun.name);
}

bool holds(const Names& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

void check_rim(std::string_view who, std::string_view what, const std::string& rim,
               const Names& names, Problems& problems) {
  if (holds(names, rim)) return;
  problems.add(
      fmt::format("{}: there is no {} named '{}'{}", who, what, rim, did_you_mean(rim, names)),
      names.empty() ? "give it a name: p:hole { name = \"bore\", ... }"
                    : "named are " + comma_list(names));
}

void check_traction(const Traction& traction, const Names& rims, const Names& cracks,
                    Problems& problems) {
  if (traction.rim.empty()) return;
  if (holds(cracks, traction.rim) && !holds(rims, traction.rim))
    problems.add(fmt::format("traction: '{}' is a crack, whose two faces it would pull the same "
                             "way",
                             traction.rim),
                 "p:pressure pushes them apart");
  else
    check_rim("traction", "hole, notch or outline", traction.rim, rims, problems);
}

void check_rims(const Plate& plate, Problems& problems) {
  Names rims, cracks;
  add_names(plate.outlines, rims);
  add_names(plate.cutouts, rims);
  add_names(plate.cracks, cracks);
  for (const Traction& traction : plate.loads.tractions)
    check_traction(traction, rims, cracks, problems);
  Names all = rims;
  all.insert(all.end(), cracks.begin(), cracks.end());
  for (const Pressure& pressure : plate.loads.pressures)
    check_rim("pressure", "hole, notch, outline or crack", pressure.rim, all, problems);
}

void check_expansion(const Plate& plate, Problems& problems) {
  const auto expands = [](const Material& material) { return material.alphaT != 0.0; };
  if (plate.loads.thermal_loads.empty() || expands(plate.material)) return;
  for (const Inclusion& inclusion : plate.inclusions)
    if (expands(inclusion.material)) return;
  problems.add(fmt::format("temperature: {} does not expand, its alphaT is 0", plate.material.name),
               "take a material with alphaT above 0; glass has 3e-6 to 9e-6 per kelvin");
}

bool is_apart(const Plate& plate, const Shape& shape) {
  const Box box = bounds(shape);
  return box.max.x() < 0.0 || box.max.y() < 0.0 || box.min.x() > plate.width ||
         box.min.y() > plate.height;
}

// Decides for convex shapes without holes, by the corners of the plate; the lattice finds the
// others.
bool swallows(const Plate& plate, const Shape& shape) {
  const bool plain =
      std::holds_alternative<Ellipse>(shape) || std::holds_alternative<Capsule>(shape);
  if (!plain) return false;
  for (const double x : {0.0, plate.width})
    for (const double y : {0.0, plate.height})
      if (!covers(shape, {x, y}, 0.0)) return false;
  return true;
}

// A node stores its material as a byte, and one value means "none".
void check_materials(const Plate& plate, Problems& problems) {
  constexpr std::size_t max = 254;
  std::vector<const Material*> distinct;
  for (const Inclusion& inclusion : plate.inclusions) {
    const auto same = [&](const Material* other) { return *other == inclusion.material; };
    if (std::ranges::none_of(distinct, same)) distinct.push_back(&inclusion.material);
  }
  if (distinct.size() > max)
    problems.add(fmt::format("plate: its inclusions are of {} different materials, the most is {}",
                             distinct.size(), max),
                 "let several of them share a material");
}

}  // namespace

Shape strip(const Plate& plate, Edge edge, double depth) {
  Vec2 min{0.0, 0.0}, max{plate.width, plate.height};
  switch (edge) {
    case Edge::left:
      max.x() = depth;
      break;
    case Edge::right:
      min.x() = plate.width - depth;
      break;
    case Edge::bottom:
      max.y() = depth;
      break;
    case Edge::top:
      min.y() = plate.height - depth;
      break;
  }
  return rectangle(min, max);
}

void check(const Plate& plate, Problems& problems) {
  check_members(plate, problems);
  check(plate.material, problems);
  for (const Outline& outline : plate.outlines) check(plate, outline, problems);
  for (const Cutout& cutout : plate.cutouts) check_cutout(plate, cutout.shape, "cut-out", problems);
  for (const Inclusion& inclusion : plate.inclusions) {
    check(plate, inclusion.shape, "inclusion", problems);
    check(inclusion.material, problems);
  }
  check_materials(plate, problems);
  for (const Crack& crack : plate.cracks) check(plate, crack, problems);
  for (const Shape& zone : plate.no_fail) check_no_fail(plate, zone, problems);
  if (plate.scatter) check_members(*plate.scatter, problems);
  if (plate.contact) check_members(*plate.contact, problems);
  check(plate.loads, problems);
  check_load_names(plate.loads, problems);
  check_rims(plate, problems);
  check_expansion(plate, problems);
}

void check(const Plate& plate, const Crack& crack, Problems& problems) {
  const bool straight = crack.points.size() == 2;
  for (std::size_t k = 0; k < crack.points.size(); ++k) {
    if (on_plate(plate, crack.points[k])) continue;
    const std::string which =
        straight ? (k == 0 ? "'from'" : "'to'") : fmt::format("point {}", k + 1);
    problems.add(
        fmt::format("crack: {} {} lies outside the plate", which, point_text(crack.points[k])),
        extent_text(plate) + ", origin at its lower left corner");
  }
  if (crack.points.size() < 2)
    problems.add("crack: it has fewer than two points");
  else if (std::ranges::adjacent_find(crack.points) == crack.points.end())
    return;
  else if (straight)
    problems.add("crack: 'from' and 'to' are the same point", "give the two ends of the crack");
  else
    problems.add("crack: two points in a row are the same");
}

void check(const Plate& plate, const Shape& shape, const std::string& who, Problems& problems) {
  const std::size_t before = problems.list().size();
  check(shape, who, problems);
  if (problems.list().size() != before || !is_apart(plate, shape)) return;
  const Box box = bounds(shape);
  problems.add(fmt::format("{}: the {} from {} to {} lies outside the plate", who, kind_of(shape),
                           point_text(box.min), point_text(box.max)),
               extent_text(plate) + ", origin at its lower left corner");
}

void check_cutout(const Plate& plate, const Shape& shape, const std::string& who,
                  Problems& problems) {
  const std::size_t before = problems.list().size();
  check(plate, shape, who, problems);
  if (problems.list().size() == before && swallows(plate, shape))
    problems.add(fmt::format("{}: the {} leaves nothing of the plate", who, kind_of(shape)),
                 extent_text(plate));
}

void check(const Plate& plate, const Outline& outline, Problems& problems) {
  if (outline.areas.empty())
    problems.add("keep: there is no area", "give at least one, or the plate has nothing");
  for (const Shape& area : outline.areas) check(plate, area, "keep", problems);
}

double contact_stiffness(const Plate& plate) {
  return plate.contact ? plate.contact->stiffness : 0.0;
}

void check_no_fail(const Plate& plate, const Shape& zone, Problems& problems) {
  check(zone, "nofail", problems);
  const Box box = bounds(zone);
  if (is_apart(plate, zone))
    problems.add(fmt::format("nofail: the zone from {} to {} lies outside the plate",
                             point_text(box.min), point_text(box.max)),
                 extent_text(plate));
}

std::string describe(const Scatter& scatter) {
  const bool weibull = scatter.kind == Scatter::Kind::weibull;
  return fmt::format(
      "strength scattered ({} {}{}, seed {})", weibull ? "Weibull modulus" : "deviation",
      shortest(scatter.spread),
      scatter.correlation > 0.0 ? ", correlated over " + quantity(scatter.correlation, "m") : "",
      scatter.seed);
}

namespace {

// Returns "E 40 to 65 GPa", or "" for a quantity that all inclusions have in common.
std::string range_of(const Plate& plate, double Material::*value, const char* name,
                     const char* unit) {
  const auto value_of = [&](const Inclusion& inclusion) { return inclusion.material.*value; };
  const auto [min, max] = std::ranges::minmax_element(plate.inclusions, {}, value_of);
  if (value_of(*min) == value_of(*max)) return "";
  return fmt::format("{} {} to {}", name, quantity(value_of(*min), unit),
                     quantity(value_of(*max), unit));
}

std::string describe_inclusions(const Plate& plate) {
  std::string ranges;
  if (plate.inclusions.empty()) return ranges;
  for (const std::string& range :
       {range_of(plate, &Material::E, "E", "Pa"), range_of(plate, &Material::rho, "rho", "kg/m3"),
        range_of(plate, &Material::G0, "G0", "J/m2")})
    if (!range.empty()) ranges += fmt::format("{}{}", ranges.empty() ? "" : ", ", range);
  return counted(plate.inclusions.size(), "inclusion") +
         (ranges.empty() ? "" : fmt::format(" ({})", ranges));
}

}  // namespace

std::string describe(const Plate& plate) {
  return fmt::format(
      "plate {} x {} mm, {}{}{}{}{}{}{}{}{}{}", shortest(std::round(plate.width * 1e9) * 1e-6),
      shortest(std::round(plate.height * 1e9) * 1e-6),
      plate.plane == Plane::strain ? "plane strain, " : "", describe(plate.material),
      counted(plate.outlines.size(), "outline"), counted(plate.cutouts.size(), "cut-out"),
      describe_inclusions(plate), counted(plate.cracks.size(), "crack"), describe(plate.loads),
      counted(plate.no_fail.size(), "no-fail zone"),
      plate.scatter ? ", " + describe(*plate.scatter) : "", plate.contact ? ", contact" : "");
}

}  // namespace hackle
