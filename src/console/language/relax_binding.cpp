// SPDX-License-Identifier: MIT
#include "console/language/relax_binding.hpp"

#include <array>

#include "base/files.hpp"
#include "console/language/scripted_run.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/schema/result_table.hpp"

namespace hackle {
namespace {

constexpr Option tolerance_option(std::string_view fallback) {
  return {.name = "tolerance",
          .range = between(1e-14, 0.1),
          .fallback = fallback,
          .sentence = "Largest residual force, as a share of the largest load or reaction."};
}

constexpr std::array relax_options{tolerance_option("1e-8")};

constexpr FunctionDoc relax_doc{
    .name = "relax",
    .owner = "s",
    .sentence =
        "Finds the static equilibrium under the present loads and heat, without breaking bonds; "
        "the surplus energy is energy.released. Returns steps, residual, most (the largest ratio "
        "of stretch to critical stretch), beyond (bonds above it).",
    .options = relax_options,
    .example = "s:relax { tolerance = 1e-6 }"};

constexpr std::array quasistatic_options{
    Option{.name = "duration",
           .unit = "s",
           .range = above(0.0),
           .required = true,
           .sentence = "Time of the amplitudes to go through; nodes with a prescribed velocity "
                       "move as far as it takes them."},
    Option{.name = "increments",
           .type = OptionType::integer,
           .range = between(1.0, 1e6),
           .fallback = "10",
           .sentence = "Number of times at which equilibrium is found, with bonds breaking."},
    tolerance_option("1e-6"),
};

constexpr FunctionDoc quasistatic_doc{
    .name = "quasistatic",
    .owner = "s",
    .sentence =
        "Applies the loads so slowly that the plate is always in equilibrium, at exact times "
        "whatever the step; functions of s:on are called between increments. Energy set free by "
        "jumps is energy.released. Returns passes (a list), steps, broken, bears (false when it "
        "came apart).",
    .options = quasistatic_options,
    .example =
        "s = simulate(plate { width = 10*mm, height = 10*mm, material = \"duran50\" }, { spacing = "
        "1*mm }) "
        "s:quasistatic { duration = 1*us }"};

constexpr auto relax_names =
    std::to_array<std::string_view>({"steps", "residual", "most", "beyond"});
constexpr auto quasistatic_names =
    std::to_array<std::string_view>({"passes", "steps", "broken", "bears"});

int relax(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, relax_doc);
  const Arguments arguments = Arguments::from_table(L, 2, relax_doc);
  arguments.problems.throw_if_any();
  const RelaxResult result = scripted.run().relax(arguments.number("tolerance", 1e-8));
  lua_createtable(L, 0, 4);
  close_names(L, "s:relax()", relax_names);
  set_integer(L, "steps", result.iterations);
  set_number(L, "residual", result.residual);
  set_number(L, "most", result.max);
  set_integer(L, "beyond", result.beyond);
  return 1;
}

int quasistatic(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, quasistatic_doc);
  const Arguments arguments = Arguments::from_table(L, 2, quasistatic_doc);
  arguments.problems.throw_if_any();
  for (const std::filesystem::path& path : scripted.promised) check_writable(path);
  const QuasistaticResult result = scripted.run().load_slowly(
      arguments.number("duration"), static_cast<int>(arguments.integer("increments", 10)),
      arguments.number("tolerance", 1e-6));
  lua_createtable(L, 0, 4);
  close_names(L, "s:quasistatic()", quasistatic_names);
  lua_createtable(L, static_cast<int>(result.passes.size()), 0);
  for (std::size_t k = 0; k < result.passes.size(); ++k) {
    lua_pushinteger(L, result.passes[k]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(k) + 1);
  }
  lua_setfield(L, -2, "passes");
  set_integer(L, "steps", result.iterations);
  set_integer(L, "broken", result.broken);
  lua_pushboolean(L, result.bears ? 1 : 0);
  lua_setfield(L, -2, "bears");
  return 1;
}

}  // namespace

std::span<const Function> relax_methods() {
  static constexpr std::array methods{
      Function{&relax_doc, guarded<relax>, Replayed::advances},
      Function{&quasistatic_doc, guarded<quasistatic>, Replayed::advances}};
  return methods;
}

}  // namespace hackle
