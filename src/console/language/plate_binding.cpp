// SPDX-License-Identifier: MIT
#include "console/language/plate_binding.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "base/units.hpp"
#include "console/language/contact_binding.hpp"
#include "console/language/grading_binding.hpp"
#include "console/language/load_binding.hpp"
#include "console/language/noun_options.hpp"
#include "console/language/region_options.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/language/shape_binding.hpp"
#include "console/language/shape_options.hpp"
#include "console/language/strength_binding.hpp"
#include "console/schema/object_type.hpp"

namespace hackle {
namespace {

// With an outline, sizes follow from it. Its loads have functions of their own.
constexpr auto plate_options = [] {
  auto options = joined(
      without("damping", without("stiffness_damping", options_of<Plate>)),
      std::array{Option{.name = "outline",
                        .type = OptionType::areas,
                        .read = read_areas,
                        .alternative = true,
                        .sentence = "Area of the rectangle that is kept, as by p:keep; without "
                                    "width and height the plate has the size of the outline. Loads "
                                    "find its rim by the name \"outline\"."}});
  for (Option& option : options)
    if (option.name == "width" || option.name == "height") option.unless = "outline";
  return options;
}();

constexpr FunctionDoc plate_doc{
    .name = "plate",
    .sentence =
        "Makes a plate; the lower left corner of its rectangle is the origin, x right, y up.",
    .options = plate_options,
    .example = "p = plate { width = 100*mm, height = 40*mm, material = \"duran50\" }"};

constexpr FunctionDoc nofail_doc{
    .name = "nofail",
    .owner = "p",
    .sentence = "Marks a strip along an edge, a rectangle or a disc in which no bond breaks.",
    .options = region_options,
    .example = "p:nofail { edge = \"top\", depth = 2*mm }"};

// Adds a problem where a size is neither given nor follows from an outline that begins at the
// origin.
void size_by(const Outline& outline, const Arguments& arguments, Plate& plate, Problems& problems) {
  const Box box = bounds(outline);
  if (!arguments.has("width")) plate.width = box.max.x();
  if (!arguments.has("height")) plate.height = box.max.y();
  const double slack = 1e-9 * (box.max - box.min).maxCoeff();
  const bool off = (!arguments.has("width") && std::abs(box.min.x()) > slack) ||
                   (!arguments.has("height") && std::abs(box.min.y()) > slack);
  if (off)
    problems.add(fmt::format("plate: the outline begins at ({}, {})", quantity(box.min.x(), "m"),
                             quantity(box.min.y(), "m")),
                 "move it to the origin, or give width and height");
}

int make_plate(lua_State* L) {
  Arguments arguments = Arguments::from_table(L, 1, plate_doc);
  const bool outlined = arguments.has("outline");
  arguments.problems.throw_if_any();
  auto plate = noun_of<Plate>(arguments);
  if (outlined) {
    plate.outlines = {{arguments.get<std::vector<Shape>>("outline", {}), "outline"}};
    size_by(plate.outlines.front(), arguments, plate, arguments.problems);
    arguments.problems.throw_if_any();
  }
  check(plate, arguments.problems);
  arguments.problems.throw_if_any();
  push_object(L, std::move(plate));
  return 1;
}

int add_nofail(lua_State* L) {
  Plate& plate = self<Plate>(L, nofail_doc);
  Arguments arguments = Arguments::from_table(L, 2, nofail_doc);
  const Region zone = region_of(arguments, plate, "nofail");
  if (!zone && arguments.problems.empty())
    arguments.problems.add("nofail: no area is given",
                           "give edge and depth, or from and to, or centre and radius");
  if (zone) check_no_fail(plate, *zone, arguments.problems);
  arguments.problems.throw_if_any();
  plate.no_fail.push_back(*zone);
  return return_plate(L);
}

constexpr std::array own_methods_of_plate{Function{&nofail_doc, guarded<add_nofail>}};

int plate_to_text(lua_State* L) {
  push_text(L, describe(*object_at<Plate>(L, 1)));
  return 1;
}

template <double Plate::*value>
int push_value(lua_State* L) {
  lua_pushnumber(L, object_at<Plate>(L, 1)->*value);
  return 1;
}

int push_material(lua_State* L) {
  push_object(L, Material(object_at<Plate>(L, 1)->material));
  return 1;
}

constexpr std::array plate_fields{
    Property{"width", "m", "Size along x.", push_value<&Plate::width>},
    Property{"height", "m", "Size along y.", push_value<&Plate::height>},
    Property{"material", "", "Its own material.", push_material},
};

// Collects the methods from all files that bind some.
std::vector<Function> all_methods_of_plate() {
  std::vector<Function> all;
  for (const std::span<const Function> part :
       {shape_methods(), std::span<const Function>(own_methods_of_plate), load_methods_of_plate(),
        grading_methods(), strength_methods(), contact_methods()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

const TypeDoc& plate_type() {
  static const std::vector<Function> all = all_methods_of_plate();
  static const TypeDoc type{.name = "plate",
                            .sentence = "A plate with its cracks and loads; simulate copies it.",
                            .methods = all,
                            .fields = plate_fields,
                            .to_text = guarded<plate_to_text>,
                            .destroy = destroy_plate};
  return type;
}

std::span<const Function> plate_functions() {
  static constexpr std::array functions{Function{&plate_doc, guarded<make_plate>}};
  return functions;
}

}  // namespace hackle
