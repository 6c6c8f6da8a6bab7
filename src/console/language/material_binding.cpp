// SPDX-License-Identifier: MIT
#include "console/language/material_binding.hpp"

#include <array>

#include <fmt/format.h>

#include "console/language/noun_options.hpp"
#include "console/language/scripted_material.hpp"
#include "console/schema/object_type.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

// Nothing is required: missing values may come from another material.
constexpr auto material_options = [] {
  auto own = options_of<Material>;
  for (Option& option : own) {
    option.alternative = option.alternative || option.required;
    option.required = false;
  }
  return joined(own, std::array{Option{
                         .name = "like",
                         .type = OptionType::material,
                         .read = read_material,
                         .alternative = true,
                         .sentence = "Another material; supplies every value that is not given."}});
}();

constexpr FunctionDoc material_doc{
    .name = "material",
    .sentence = "Returns a brittle material: from the library, material \"duran50\", or your own.",
    .options = material_options,
    .example = "material { name = \"PMMA\", E = 3.09*GPa, rho = 1180, nu = 0.35, G0 = 300 }"};

// Requires the values of a material that is not `like` another. Exactly one of G0 and s0 is needed
// in any case.
void require_all_values(Arguments& arguments) {
  if (!arguments.good({"E", "rho", "G0", "s0", "like"})) return;
  if (arguments.has("G0") && arguments.has("s0"))
    arguments.problems.add("material: both G0 and s0 are given",
                           "give one: each follows from the other");
  if (arguments.has("like")) return;
  for (const char* name : {"E", "rho"})
    if (!arguments.has(name))
      arguments.problems.add(fmt::format("material: {} is missing", name),
                             std::string(material_doc.example));
  if (!arguments.has("G0") && !arguments.has("s0"))
    arguments.problems.add("material: G0 is missing", "or give the critical stretch, s0");
}

Material material_of(const Arguments& arguments) {
  Material material = arguments.get<Material>("like", {});
  if (!arguments.has("like")) material.nu = 1.0 / 3.0;
  const std::string like = arguments.has("like") ? "like " + material.name : "own material";
  material.name = like;
  if (arguments.has("G0") || arguments.has("s0")) material.G0 = material.s0 = 0.0;
  read_options(arguments, material);
  return material;
}

int make_material(lua_State* L) {
  if (lua_type(L, 1) == LUA_TSTRING) {
    push_object(L, session_of(L).materials().find(lua_tostring(L, 1)).material);
    return 1;
  }
  Arguments arguments = Arguments::from_table(L, 1, material_doc);
  require_all_values(arguments);
  arguments.problems.throw_if_any();
  const Material material = material_of(arguments);
  check(material, arguments.problems);
  arguments.problems.throw_if_any();
  push_object(L, material);
  return 1;
}

int to_text(lua_State* L) {
  push_text(L, describe(*object_at<Material>(L, 1)));
  return 1;
}

template <double Material::*value>
int push_value(lua_State* L) {
  lua_pushnumber(L, object_at<Material>(L, 1)->*value);
  return 1;
}

int push_name(lua_State* L) {
  push_text(L, object_at<Material>(L, 1)->name);
  return 1;
}

constexpr std::array fields{
    Property{"name", "", "Name in reports.", push_name},
    Property{"E", "Pa", "Young's modulus.", push_value<&Material::E>},
    Property{"rho", "kg/m3", "Density.", push_value<&Material::rho>},
    Property{"nu", "", "Poisson's ratio of the real material.", push_value<&Material::nu>},
    Property{"G0", "J/m2", "Fracture energy.", push_value<&Material::G0>},
    Property{"alpha", "", "Toughening by compression.", push_value<&Material::alpha>},
    Property{"alphaT", "1/K", "Thermal expansion.", push_value<&Material::alphaT>},
    Property{"s0", "", "Critical stretch if it was given, else 0.", push_value<&Material::s0>},
};

constexpr TypeDoc type{.name = "material",
                       .sentence = "A linear elastic, ideally brittle material.",
                       .fields = fields,
                       .to_text = guarded<to_text>,
                       .destroy = destroy_object<Material>};

}  // namespace

const TypeDoc& material_type() {
  return type;
}

std::span<const Function> material_functions() {
  static constexpr std::array functions{Function{&material_doc, guarded<make_material>}};
  return functions;
}

}  // namespace hackle
