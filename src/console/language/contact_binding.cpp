// SPDX-License-Identifier: MIT
#include "console/language/contact_binding.hpp"

#include <array>

#include "console/language/noun_options.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/schema/object_type.hpp"

namespace hackle {
namespace {

constexpr FunctionDoc contact_doc{
    .name = "contact",
    .owner = "p",
    .sentence =
        "Makes the faces of cracks and fragments repel each other in runs: a closed crack bears "
        "pressure like the plate and slides freely; quasi-static loading ignores it.",
    .options = options_of<Contact>,
    .example = "p:contact {}"};

int set_contact(lua_State* L) {
  Plate& plate = self<Plate>(L, contact_doc);
  const Arguments arguments = Arguments::from_table(L, 2, contact_doc);
  arguments.problems.throw_if_any();
  plate.contact = noun_of<Contact>(arguments);
  return return_plate(L);
}

}  // namespace

std::span<const Function> contact_methods() {
  static constexpr std::array methods{Function{&contact_doc, guarded<set_contact>}};
  return methods;
}

}  // namespace hackle
