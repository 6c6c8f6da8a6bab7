// SPDX-License-Identifier: MIT
#include "console/material_binding.hpp"

#include <array>

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
           .required = true,
           .sentence = "Young's modulus."},
    Option{.name = "rho",
           .unit = "kg/m3",
           .range = above(0.0),
           .required = true,
           .sentence = "Density."},
    Option{.name = "nu",
           .range = between(-0.99, 0.49),
           .fallback = "1/3",
           .sentence =
               "Poisson's ratio of the real material; the model's is 1/3, 1/4 in plane strain."},
    Option{.name = "G0",
           .unit = "J/m2",
           .range = above(0.0),
           .required = true,
           .sentence = "Fracture energy of the model, 2 gamma."},
    Option{.name = "alpha",
           .range = between(0.0, 0.99),
           .fallback = "0",
           .sentence = "How far compression toughens it; 0.02 and 0.25 are in use."},
};

constexpr FunctionDoc material_doc{
    .name = "material",
    .sentence = "A brittle material: one of the library, material \"duran50\", or your own.",
    .options = material_options,
    .example = "material { name = \"PMMA\", E = 3.09*GPa, rho = 1180, nu = 0.35, G0 = 300 }"};

int make_material(lua_State* L) {
  if (lua_type(L, 1) == LUA_TSTRING) {
    push_object(L, session_of(L).materials().find(lua_tostring(L, 1)).material);
    return 1;
  }
  Arguments arguments = Arguments::from_table(L, 1, material_doc);
  arguments.problems.throw_if_any();
  push_object(L, Material{arguments.text("name", "own material"), arguments.number("E"),
                          arguments.number("rho"), arguments.number("nu", 1.0 / 3.0),
                          arguments.number("G0"), arguments.number("alpha", 0.0)});
  return 1;
}

constexpr std::array functions{Function{&material_doc, guarded<make_material>}};

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
  return functions;
}

}  // namespace hackle
