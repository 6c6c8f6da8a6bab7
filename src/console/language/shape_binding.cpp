// SPDX-License-Identifier: MIT
#include "console/language/shape_binding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "console/language/mask.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/language/shape_docs.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/session.hpp"
#include "scene/geometry.hpp"
#include "scene/random_cracks.hpp"

namespace hackle {
namespace {

int add_hole(lua_State* L) {
  Plate& plate = self<Plate>(L, hole_doc);
  Arguments arguments = Arguments::from_table(L, 2, hole_doc);
  const std::optional<Shape> shape = shape_of(arguments, "hole");
  if (shape) check_cutout(plate, *shape, "hole", arguments.problems);
  arguments.problems.throw_if_any();
  plate.cutouts.push_back({*shape, arguments.text("name"), arguments.choice<Bridging>("bonds")});
  return return_plate(L);
}

int add_keep(lua_State* L) {
  Plate& plate = self<Plate>(L, keep_doc);
  Arguments arguments = Arguments::from_table(L, 2, keep_doc);
  Outline outline{arguments.get<std::vector<Shape>>("any", {}), arguments.text("name")};
  const bool shaped = std::ranges::any_of(
      shape_options, [&](const Option& option) { return arguments.has(option.name); });
  if (arguments.has("any") && shaped)
    arguments.problems.add("keep: any and another area are given",
                           "put all areas into any = { {...}, {...} }");
  if (!arguments.has("any") && arguments.good({"any"}))
    if (const std::optional<Shape> shape = shape_of(arguments, "keep")) outline.areas = {*shape};
  if (!outline.areas.empty()) check(plate, outline, arguments.problems);
  arguments.problems.throw_if_any();
  plate.outlines.push_back(std::move(outline));
  return return_plate(L);
}

int add_notch(lua_State* L) {
  Plate& plate = self<Plate>(L, notch_doc);
  Arguments arguments = Arguments::from_table(L, 2, notch_doc);
  const Notch notch{arguments.point("at"), arguments.number("depth"), arguments.number("width"),
                    arguments.choice<Notch::Kind>("shape"), arguments.number("angle")};
  if (arguments.has("at") && arguments.has("depth") && arguments.has("width"))
    check(plate, notch, arguments.problems);
  arguments.problems.throw_if_any();
  const Shape shape = shape_of(notch, plate);
  check_cutout(plate, shape, "notch", arguments.problems);
  arguments.problems.throw_if_any();
  plate.cutouts.push_back({shape, arguments.text("name")});
  return return_plate(L);
}

constexpr std::array<std::string_view, 2> straight{"from", "to"};
constexpr std::array<std::string_view, 1> polyline{"points"};
constexpr std::array<std::string_view, 3> along_arc{"centre", "radius", "angles"};
constexpr std::array<std::string_view, 1> polyline_unit{"unit"};
constexpr std::array crack_forms{Form{straight}, Form{polyline, polyline_unit}, Form{along_arc}};

std::vector<Vec2> arc_of(Arguments& arguments) {
  const Vec2 angles = arguments.pair("angles");
  const double turn = std::abs(angles.y() - angles.x());
  if (turn > 0.0 && turn <= 2.0 * std::numbers::pi + 1e-9)
    return arc(arguments.point("centre"), arguments.number("radius"), angles.x(), angles.y());
  arguments.problems.add(
      fmt::format("crack: the arc goes {:.4g} degrees", turn * 180.0 / std::numbers::pi),
      "angles = {from, to} must differ by at most 360*deg, and not by 0");
  return {};
}

std::vector<Vec2> points_of(Arguments& arguments, std::size_t form) {
  if (form == 0) return {arguments.point("from"), arguments.point("to")};
  if (form == 2) return arc_of(arguments);
  std::vector<Vec2> points = arguments.points("points");
  for (Vec2& point : points) point *= arguments.number("unit", 1.0);
  return points;
}

int add_crack(lua_State* L) {
  Plate& plate = self<Plate>(L, crack_doc);
  Arguments arguments = Arguments::from_table(L, 2, crack_doc);
  const auto form = form_of(arguments, crack_forms, "crack", "its course");
  Crack crack;
  if (form)
    crack = {points_of(arguments, *form), arguments.choice<Born>("born"),
             arguments.choice<CrackEnds>("ends")};
  crack.name = arguments.text("name");
  if (!crack.points.empty()) check(plate, crack, arguments.problems);
  arguments.problems.throw_if_any();
  plate.cracks.push_back(std::move(crack));
  return return_plate(L);
}

// Returns the rectangle from `from` to `to`, or the plate if neither is given. Adds a problem if
// only one is given.
Box area_of(Arguments& arguments, const Plate& plate, std::string_view who) {
  const bool good = arguments.good({"from", "to"});
  if (good && arguments.has("from") != arguments.has("to"))
    arguments.problems.add(fmt::format("{}: from and to are given together or not at all", who));
  if (!arguments.has("from") || !arguments.has("to")) return {{0, 0}, {plate.width, plate.height}};
  return {arguments.point("from"), arguments.point("to")};
}

int add_random_cracks(lua_State* L) {
  Plate& plate = self<Plate>(L, random_cracks_doc);
  Arguments arguments = Arguments::from_table(L, 2, random_cracks_doc);
  RandomCracks cracks;
  cracks.count = static_cast<int>(arguments.integer("count"));
  cracks.length = arguments.pair("length");
  cracks.angle = arguments.pair("angle", cracks.angle);
  cracks.seed = arguments.integer("seed", cracks.seed);
  cracks.area = area_of(arguments, plate, "random_cracks");
  cracks.born = arguments.choice<Born>("born");
  check(plate, cracks, arguments.problems);
  arguments.problems.throw_if_any();
  for (Crack& crack : make(cracks)) plate.cracks.push_back(std::move(crack));
  return return_plate(L);
}

int add_inclusion(lua_State* L) {
  Plate& plate = self<Plate>(L, inclusion_doc);
  Arguments arguments = Arguments::from_table(L, 2, inclusion_doc);
  const std::optional<Shape> shape = shape_of(arguments, "inclusion");
  if (shape) check(plate, *shape, "inclusion", arguments.problems);
  arguments.problems.throw_if_any();
  plate.inclusions.push_back({*shape, arguments.get<Material>("material", {})});
  return return_plate(L);
}

int add_mask(lua_State* L) {
  Plate& plate = self<Plate>(L, mask_doc);
  Arguments arguments = Arguments::from_table(L, 2, mask_doc);
  const Box area = area_of(arguments, plate, "mask");
  if (!((area.max - area.min).minCoeff() > 0.0))
    arguments.problems.add("mask: the area is empty",
                           "from is its lower left corner, to its upper right one");
  arguments.problems.throw_if_any();
  const Shape shape =
      read_mask(session_of(L).input_path("mask", arguments.text("file")), area,
                arguments.choice<Mask>("remove"), arguments.number("threshold", 0.5));
  const bool cut = !arguments.has("material");
  if (cut)
    check_cutout(plate, shape, "mask", arguments.problems);
  else
    check(plate, shape, "mask", arguments.problems);
  arguments.problems.throw_if_any();
  if (cut)
    plate.cutouts.push_back({shape, arguments.text("name")});
  else
    plate.inclusions.push_back({shape, arguments.get<Material>("material", {})});
  return return_plate(L);
}

}  // namespace

std::span<const Function> shape_methods() {
  static constexpr std::array methods{Function{&crack_doc, guarded<add_crack>},
                                      Function{&random_cracks_doc, guarded<add_random_cracks>},
                                      Function{&notch_doc, guarded<add_notch>},
                                      Function{&hole_doc, guarded<add_hole>},
                                      Function{&keep_doc, guarded<add_keep>},
                                      Function{&inclusion_doc, guarded<add_inclusion>},
                                      Function{&mask_doc, guarded<add_mask>}};
  return methods;
}

}  // namespace hackle
