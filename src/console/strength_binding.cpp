// SPDX-License-Identifier: MIT
#include "console/strength_binding.hpp"

#include <array>

#include <fmt/format.h>

#include "console/arguments.hpp"
#include "console/plate_binding.hpp"
#include "console/plate_memory.hpp"

namespace hackle {
namespace {

// In the order of Scatter::Kind.
constexpr std::array<std::string_view, 2> distribution_names{"weibull", "normal"};

constexpr std::array strength_options{
    Option{.name = "distribution",
           .type = OptionType::choice,
           .fallback = "weibull",
           .choices = distribution_names,
           .sentence = "Of the critical stretch over that of the material; its mean is 1."},
    Option{.name = "modulus",
           .range = between(1.0, 1000.0),
           .alternative = true,
           .sentence = "Weibull modulus; 5 to 15 is usual for glass, more scatters less."},
    Option{.name = "deviation",
           .range = Range{.least = 0.0, .most = 0.3, .least_is_in = false},
           .alternative = true,
           .sentence = "Standard deviation of a normal distribution; it is cut off at three."},
    Option{.name = "correlation",
           .unit = "m",
           .range = at_least(0.0),
           .fallback = "0",
           .sentence = "Distance over which strength changes; 0: every node for itself, and then "
                       "the flaws depend on the spacing."},
    Option{.name = "seed",
           .type = OptionType::integer,
           .fallback = "1",
           .sentence = "Another whole number gives other flaws."},
};

constexpr FunctionDoc strength_doc{
    .name = "strength",
    .owner = "p",
    .sentence = "Lets strength differ from place to place, the same on every machine.",
    .options = strength_options,
    .example =
        "p:strength { distribution = \"weibull\", modulus = 10, correlation = 2*mm, seed = 7 }"};

// The spread goes by another name for each distribution.
void check_spread(Arguments& arguments, Scatter::Kind kind) {
  const bool weibull = kind == Scatter::Kind::weibull;
  const char* const wanted = weibull ? "modulus" : "deviation";
  const char* const other = weibull ? "deviation" : "modulus";
  if (!arguments.good({"distribution", wanted, other})) return;
  if (!arguments.has(wanted) || arguments.has(other))
    arguments.problems.add(
        fmt::format("strength: a {} distribution takes {} and no {}",
                    distribution_names[static_cast<std::size_t>(kind)], wanted, other),
        weibull ? "give modulus, or distribution = \"normal\" and deviation"
                : "give deviation, or distribution = \"weibull\" and modulus");
}

int set_strength(lua_State* L) {
  Plate& plate = self<Plate>(L, strength_doc);
  Arguments arguments = Arguments::from_table(L, 2, strength_doc);
  Scatter scatter;
  scatter.kind = arguments.choice<Scatter::Kind>("distribution");
  check_spread(arguments, scatter.kind);
  arguments.problems.throw_if_any();
  scatter.spread =
      arguments.number(scatter.kind == Scatter::Kind::weibull ? "modulus" : "deviation");
  scatter.correlation = arguments.number("correlation");
  scatter.seed = arguments.integer("seed", 1);
  plate.scatter = scatter;
  return return_plate(L);
}

}  // namespace

std::span<const Function> strength_methods() {
  static constexpr std::array methods{Function{&strength_doc, guarded<set_strength>}};
  return methods;
}

}  // namespace hackle
