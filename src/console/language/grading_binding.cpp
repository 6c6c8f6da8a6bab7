// SPDX-License-Identifier: MIT
#include "console/language/grading_binding.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "console/language/scripted_material.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/language/shape_options.hpp"
#include "console/schema/object_type.hpp"
#include "scene/grading.hpp"

namespace hackle {
namespace {

constexpr Option graded_option(std::size_t index, std::string_view sentence) {
  return {.name = graded_names[index],
          .type = OptionType::scalar_field,
          .unit = graded_units[index],
          .range = above(0.0),
          .alternative = true,
          .sentence = sentence};
}

constexpr std::array own_grade_options{
    graded_option(0, "Young's modulus."),
    graded_option(1, "Density."),
    graded_option(2, "Fracture energy."),
    graded_option(3, "Factor on the critical stretch; the fracture energy goes with its square."),
    Option{.name = "material",
           .type = OptionType::material,
           .read = read_material,
           .fallback = "that of the plate",
           .sentence = "Material that has all that is not graded."},
    Option{.name = "levels",
           .type = OptionType::integer,
           .range = between(2, most_levels),
           .fallback = "16",
           .sentence = "Number of levels, equal parts of the range of each quantity, to which it "
                       "is rounded."},
    Option{.name = "cell",
           .unit = "m",
           .range = above(0.0),
           .fallback = "1/400 of the longer side",
           .sentence = "Side of the square cells in whose middle the functions are asked; with "
                       "one spacing each node is asked."},
};

constexpr auto grade_shape_options = [] {
  auto options = shape_options;
  for (Option& option : options)
    if (option.name == "centre")
      option.sentence = "Centre of an area of any shape of a hole; default: the whole plate.";
  return options;
}();

constexpr auto grade_options = joined(own_grade_options, grade_shape_options);

constexpr FunctionDoc grade_doc{
    .name = "grade",
    .owner = "p",
    .sentence =
        "Lets the material of an area, or of the whole plate, change from place to place, "
        "in levels that are inclusions.",
    .options = grade_options,
    .example = "p:grade { E = function(x, y) return (40 + 300*x)*GPa end, levels = 8 }"};

bool has_shape(const Arguments& arguments) {
  return std::ranges::any_of(shape_options,
                             [&](const Option& option) { return arguments.has(option.name); });
}

Grading grading_of(Arguments& arguments, const Plate& plate) {
  Grading grading;
  grading.material = arguments.get<Material>("material", plate.material);
  for (std::size_t k = 0; k < Grading::quantities; ++k)
    if (arguments.has(graded_names[k]))
      grading.fields[k] = arguments.get<ScalarField>(graded_names[k], {});
  grading.levels = static_cast<int>(arguments.integer("levels", grading.levels));
  grading.cell = arguments.number("cell");
  if (has_shape(arguments)) grading.region = shape_of(arguments, "grade");
  if (grading.region) check(plate, *grading.region, "grade", arguments.problems);
  return grading;
}

int add_grading(lua_State* L) {
  Plate& plate = self<Plate>(L, grade_doc);
  Arguments arguments = Arguments::from_table(L, 2, grade_doc);
  const Grading grading = grading_of(arguments, plate);
  if (arguments.good({"E", "rho", "G0", "strength", "cell"}))
    check(plate, grading, arguments.problems);
  arguments.problems.throw_if_any();
  std::vector<Inclusion> levels = make(plate, grading);
  for (const Inclusion& level : levels) check(level.material, arguments.problems);
  arguments.problems.throw_if_any();
  std::ranges::move(levels, std::back_inserter(plate.inclusions));
  return return_plate(L);
}

}  // namespace

std::span<const Function> grading_methods() {
  static constexpr std::array methods{Function{&grade_doc, guarded<add_grading>}};
  return methods;
}

}  // namespace hackle
