// SPDX-License-Identifier: MIT
#include "console/language/shape_options.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "base/text.hpp"
#include "console/lua/description.hpp"
#include "console/schema/given_value.hpp"
#include "console/schema/value_reader.hpp"
#include "scene/self_crossing.hpp"

namespace hackle {
namespace {

// One form of a shape, and the function that makes it from the arguments.
struct ShapeForm {
  Form form;
  Shape (*make)(const Arguments& arguments);
};

constexpr auto circle = std::to_array<std::string_view>({"centre", "radius"});
constexpr auto ellipse = std::to_array<std::string_view>({"centre", "radii"});
constexpr auto turned = std::to_array<std::string_view>({"angle"});
constexpr auto polygon = std::to_array<std::string_view>({"points"});
constexpr auto in_unit = std::to_array<std::string_view>({"unit"});
constexpr auto slot = std::to_array<std::string_view>({"from", "to", "width"});
constexpr auto regular = std::to_array<std::string_view>({"centre", "radius", "corners"});
constexpr auto ring = std::to_array<std::string_view>({"centre", "radius", "inner"});
constexpr auto pointed = std::to_array<std::string_view>({"centre", "radius", "inner", "corners"});

Shape make_circle(const Arguments& arguments) {
  return Ellipse{arguments.point("centre"), Vec2::Constant(arguments.number("radius")), 0.0};
}

Shape make_ellipse(const Arguments& arguments) {
  return Ellipse{arguments.point("centre"), arguments.pair("radii"), arguments.number("angle")};
}

Shape make_polygon(const Arguments& arguments) {
  return moved(Polygon{arguments.points("points")}, {0, 0}, arguments.number("unit", 1.0));
}

Shape make_slot(const Arguments& arguments) {
  return Capsule{{arguments.point("from"), arguments.point("to")}, 0.5 * arguments.number("width")};
}

Shape make_regular(const Arguments& arguments) {
  return star(arguments.point("centre"), arguments.number("radius"),
              static_cast<int>(arguments.integer("corners")), arguments.number("angle"));
}

Shape make_ring(const Arguments& arguments) {
  return Ring{arguments.point("centre"), arguments.number("radius"), arguments.number("inner")};
}

Shape make_star(const Arguments& arguments) {
  return star(arguments.point("centre"), arguments.number("radius"),
              static_cast<int>(arguments.integer("corners")), arguments.number("angle"),
              arguments.number("inner"));
}

constexpr std::array shapes{
    ShapeForm{{circle}, make_circle},
    ShapeForm{{ellipse, turned}, make_ellipse},
    ShapeForm{{polygon, in_unit}, make_polygon},
    ShapeForm{{slot}, make_slot},
    ShapeForm{{ring}, make_ring},
    ShapeForm{{regular, turned}, make_regular},
    ShapeForm{{pointed, turned}, make_star},
};
constexpr auto shape_forms = [] {
  std::array<Form, shapes.size()> forms;
  std::ranges::transform(shapes, forms.begin(), &ShapeForm::form);
  return forms;
}();

bool holds(std::span<const std::string_view> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

std::set<std::string_view> names_in(std::span<const Form> forms) {
  std::set<std::string_view> names;
  for (const Form& form : forms) {
    names.insert(form.needed.begin(), form.needed.end());
    names.insert(form.allowed.begin(), form.allowed.end());
  }
  return names;
}

// Returns "give centre, radius; or centre, radii and maybe angle; or points".
std::string ways(std::span<const Form> forms) {
  std::string text;
  for (const Form& form : forms) {
    text += (text.empty() ? "give " : "; or ") + comma_list(form.needed);
    if (!form.allowed.empty()) text += " and maybe " + comma_list(form.allowed);
  }
  return text;
}

// Reads the area at the top of the stack.
std::optional<Shape> area_at_top(const GivenValue& given) {
  const std::string name = given.name();
  const FunctionDoc doc{.name = name, .options = shape_options};
  if (lua_type(given.L, -1) != LUA_TTABLE) {
    given.wrong(fmt::format("{} holds {}, expected {}", given.name(), description(given.L, -1),
                            expectation(given.option)));
    return std::nullopt;
  }
  Arguments arguments = Arguments::from_table(given.L, lua_gettop(given.L), doc);
  std::optional<Shape> shape = shape_of(arguments, name);
  if (shape) check(*shape, name, arguments.problems);
  for (const Problem& problem : arguments.problems.list())
    given.problems.add(problem.what, problem.remedy);
  return arguments.problems.empty() ? shape : std::nullopt;
}

}  // namespace

std::any read_corners(const GivenValue& given) {
  std::any value = read_points(given);
  if (!value.has_value() || lua_type(given.L, given.index) != LUA_TSTRING) return value;
  Polygon polygon{std::any_cast<std::vector<Vec2>>(std::move(value))};
  std::vector<Vec2>& points = polygon.points;
  if (points.size() > 3 && points.front() == points.back()) points.pop_back();
  if (const auto crossed = crossing_sides(polygon))
    return given.wrong(
        fmt::format("{}: the side from point {} of '{}' crosses that from point {}", given.name(),
                    crossed->first + 1, text_at(given.L, given.index), crossed->second + 1),
        "list the points in their order around the area");
  return std::move(points);
}

std::any read_areas(const GivenValue& given) {
  if (lua_type(given.L, given.index) != LUA_TTABLE) return given.wrong_type();
  const lua_Unsigned count = lua_rawlen(given.L, given.index);
  std::vector<Shape> areas;
  for (lua_Unsigned k = 1; k <= std::max(count, lua_Unsigned{1}); ++k) {
    if (count == 0)
      lua_pushvalue(given.L, given.index);
    else
      lua_rawgeti(given.L, given.index, static_cast<lua_Integer>(k));
    const std::optional<Shape> area = area_at_top(given);
    lua_pop(given.L, 1);
    if (!area) return {};
    areas.push_back(*area);
  }
  return areas;
}

std::optional<std::size_t> form_of(Arguments& arguments, std::span<const Form> forms,
                                   std::string_view who, std::string_view what) {
  std::set<std::string_view> given;
  for (const std::string_view name : names_in(forms)) {
    if (!arguments.good({name})) return std::nullopt;
    if (arguments.has(name)) given.insert(name);
  }
  for (std::size_t k = 0; k < forms.size(); ++k) {
    const auto has = [&](std::string_view name) { return given.contains(name); };
    const auto known = [&](std::string_view name) {
      return holds(forms[k].needed, name) || holds(forms[k].allowed, name);
    };
    if (std::ranges::all_of(forms[k].needed, has) && std::ranges::all_of(given, known)) return k;
  }
  arguments.problems.add(fmt::format("{}: {} is not clear", who, what), ways(forms));
  return std::nullopt;
}

std::optional<Shape> shape_of(Arguments& arguments, std::string_view who) {
  const auto form = form_of(arguments, shape_forms, who, "the shape");
  return form ? std::optional(shapes[*form].make(arguments)) : std::nullopt;
}

}  // namespace hackle
