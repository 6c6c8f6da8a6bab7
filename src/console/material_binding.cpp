// SPDX-License-Identifier: MIT
#include "console/material_binding.hpp"

#include <array>

#include <fmt/format.h>

#include "console/arguments.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

constexpr std::array material_options{
    Option{.name = "name",
           .type = OptionType::text,
           .fallback = "own material",
           .sentence = "What reports call it."},
    Option{.name = "E",
           .unit = "Pa",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Young's modulus."},
    Option{.name = "rho",
           .unit = "kg/m3",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Density."},
    Option{.name = "nu",
           .range = between(-0.99, 0.49),
           .fallback = "1/3",
           .sentence =
               "Poisson's ratio of the real material; the model's is 1/3, 1/4 in plane strain."},
    Option{.name = "G0",
           .unit = "J/m2",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Fracture energy of the model, 2 gamma; or give s0."},
    Option{.name = "s0",
           .range = Range{.least = 0.0, .most = 0.99, .least_is_in = false},
           .alternative = true,
           .sentence = "Critical stretch instead of G0, which then follows from it."},
    Option{.name = "alphaT",
           .unit = "1/K",
           .range = at_least(0.0),
           .fallback = "0",
           .sentence = "Thermal expansion."},
    Option{.name = "fringe",
           .unit = "N/m",
           .range = at_least(0.0),
           .fallback = "0, not known",
           .sentence = "Stress-optic fringe value, for pictures of fringes."},
    Option{.name = "like",
           .type = OptionType::material,
           .alternative = true,
           .sentence = "Another material, of which it has all that is not given here."},
    Option{.name = "alpha",
           .range = between(0.0, 0.99),
           .fallback = "0",
           .sentence = "How far compression toughens it. The paper names two: 0.25, which it calls "
                       "typical, and 0.02, with which it computes; both after Silling & Askari."},
};

constexpr FunctionDoc material_doc{
    .name = "material",
    .sentence = "A brittle material: one of the library, material \"duran50\", or your own.",
    .options = material_options,
    .example = "material { name = \"PMMA\", E = 3.09*GPa, rho = 1180, nu = 0.35, G0 = 300 }"};

// What a material needs that is not like another. Exactly one of G0 and s0, anyway.
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
  Material material = arguments.material("like");
  if (!arguments.has("like")) material.nu = 1.0 / 3.0;
  const std::string like = arguments.has("like") ? "like " + material.name : "own material";
  material.name = arguments.text("name", like);
  material.E = arguments.number("E", material.E);
  material.rho = arguments.number("rho", material.rho);
  material.nu = arguments.number("nu", material.nu);
  material.alpha = arguments.number("alpha", material.alpha);
  material.alphaT = arguments.number("alphaT", material.alphaT);
  material.fringe = arguments.number("fringe", material.fringe);
  if (arguments.has("G0") || arguments.has("s0")) {
    material.G0 = arguments.number("G0");
    material.s0 = arguments.number("s0");
  }
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
    Property{"name", "", "What reports call it.", push_name},
    Property{"E", "Pa", "Young's modulus.", push_value<&Material::E>},
    Property{"rho", "kg/m3", "Density.", push_value<&Material::rho>},
    Property{"nu", "", "Poisson's ratio of the real material.", push_value<&Material::nu>},
    Property{"G0", "J/m2", "Fracture energy.", push_value<&Material::G0>},
    Property{"alpha", "", "How far compression toughens it.", push_value<&Material::alpha>},
    Property{"alphaT", "1/K", "Thermal expansion.", push_value<&Material::alphaT>},
    Property{"s0", "", "Critical stretch where it is given, or 0.", push_value<&Material::s0>},
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
