// SPDX-License-Identifier: MIT
#include "console/language/strength_binding.hpp"

#include <array>

#include <fmt/format.h>

#include "console/language/noun_options.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/schema/object_type.hpp"

namespace hackle {
namespace {

// Neither spread is required here: the distribution decides which one is needed.
constexpr auto strength_options = [] {
  auto options = options_of<Scatter>;
  for (Option& option : options) option.required = false;
  return options;
}();

constexpr FunctionDoc strength_doc{
    .name = "strength",
    .owner = "p",
    .sentence = "Scatters the strength over the plate, identically on every machine.",
    .options = strength_options,
    .example =
        "p:strength { distribution = \"weibull\", modulus = 10, correlation = 2*mm, seed = 7 }"};

// The spread has another name for each distribution.
void check_spread(Arguments& arguments, Scatter::Kind kind) {
  const bool weibull = kind == Scatter::Kind::weibull;
  const char* const wanted = weibull ? "modulus" : "deviation";
  const char* const other = weibull ? "deviation" : "modulus";
  if (!arguments.good({"distribution", wanted, other})) return;
  if (!arguments.has(wanted) || arguments.has(other))
    arguments.problems.add(
        fmt::format("strength: a {} distribution takes {} and no {}", name_of(kind), wanted, other),
        weibull ? "give modulus, or distribution = \"normal\" and deviation"
                : "give deviation, or distribution = \"weibull\" and modulus");
}

int set_strength(lua_State* L) {
  Plate& plate = self<Plate>(L, strength_doc);
  Arguments arguments = Arguments::from_table(L, 2, strength_doc);
  check_spread(arguments, arguments.choice<Scatter::Kind>("distribution"));
  arguments.problems.throw_if_any();
  plate.scatter = noun_of<Scatter>(arguments);
  return return_plate(L);
}

}  // namespace

std::span<const Function> strength_methods() {
  static constexpr std::array methods{Function{&strength_doc, guarded<set_strength>}};
  return methods;
}

}  // namespace hackle
