// SPDX-License-Identifier: MIT
#include "console/contact_binding.hpp"

#include <array>

#include "console/arguments.hpp"
#include "console/plate_binding.hpp"
#include "console/plate_memory.hpp"

namespace hackle {
namespace {

constexpr std::array contact_options{
    Option{.name = "stiffness",
           .range = Range{.least = 0.0, .most = 100.0, .least_is_in = false},
           .fallback = "15",
           .sentence = "Of the repulsion, over that of a bond; the default is LAMMPS's."},
    Option{.name = "reach",
           .range = Range{.least = 0.0, .most = 1.0, .least_is_in = false},
           .fallback = "0.9",
           .sentence = "Nodes touch below so much of their distance at rest, or of 1.5 spacings if "
                       "that is less."},
};

constexpr FunctionDoc contact_doc{
    .name = "contact",
    .owner = "p",
    .sentence = "Lets the faces of cracks and fragments push each other away.",
    .options = contact_options,
    .example = "p:contact {}"};

int set_contact(lua_State* L) {
  Plate& plate = self<Plate>(L, contact_doc);
  const Arguments arguments = Arguments::from_table(L, 2, contact_doc);
  arguments.problems.throw_if_any();
  const Contact usual;
  plate.contact = Contact{arguments.number("stiffness", usual.stiffness),
                          arguments.number("reach", usual.reach)};
  return return_plate(L);
}

}  // namespace

std::span<const Function> contact_methods() {
  static constexpr std::array methods{Function{&contact_doc, guarded<set_contact>}};
  return methods;
}

}  // namespace hackle
