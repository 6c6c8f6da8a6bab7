// SPDX-License-Identifier: MIT
#include "console/language/shape_options.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "base/text.hpp"

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
constexpr auto slot = std::to_array<std::string_view>({"from", "to", "width"});
constexpr auto regular = std::to_array<std::string_view>({"centre", "radius", "corners"});
constexpr auto pointed = std::to_array<std::string_view>({"centre", "radius", "inner", "corners"});

Shape make_circle(const Arguments& arguments) {
  return Ellipse{arguments.point("centre"), Vec2::Constant(arguments.number("radius")), 0.0};
}

Shape make_ellipse(const Arguments& arguments) {
  return Ellipse{arguments.point("centre"), arguments.pair("radii"), arguments.number("angle")};
}

Shape make_polygon(const Arguments& arguments) {
  return Polygon{arguments.points("points")};
}

Shape make_slot(const Arguments& arguments) {
  return Capsule{{arguments.point("from"), arguments.point("to")}, 0.5 * arguments.number("width")};
}

Shape make_regular(const Arguments& arguments) {
  return star(arguments.point("centre"), arguments.number("radius"),
              static_cast<int>(arguments.integer("corners")), arguments.number("angle"));
}

Shape make_star(const Arguments& arguments) {
  return star(arguments.point("centre"), arguments.number("radius"),
              static_cast<int>(arguments.integer("corners")), arguments.number("angle"),
              arguments.number("inner"));
}

constexpr std::array shapes{
    ShapeForm{{circle}, make_circle},           ShapeForm{{ellipse, turned}, make_ellipse},
    ShapeForm{{polygon}, make_polygon},         ShapeForm{{slot}, make_slot},
    ShapeForm{{regular, turned}, make_regular}, ShapeForm{{pointed, turned}, make_star},
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

}  // namespace

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
