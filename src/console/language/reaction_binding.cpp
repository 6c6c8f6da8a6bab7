// SPDX-License-Identifier: MIT
#include "console/language/reaction_binding.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/text.hpp"
#include "console/language/scripted_run.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/schema/result_table.hpp"

namespace hackle {
namespace {

constexpr std::array reaction_options{
    Option{.name = "name",
           .type = OptionType::text,
           .required = true,
           .sentence = "Name of a load, or its kind with its number, as \"support1\"."},
};
constexpr FunctionDoc reaction_doc{
    .name = "reaction",
    .owner = "s",
    .call = Call::values,
    .sentence =
        "Returns the force of the plate on a clamp, a moved area, an impactor, a roller, a platen "
        "or a foundation: name, body (its kind), number, x, y (its centre, or the mean place of "
        "its nodes, m), fx, fy (N per metre of thickness), moment (of the forces on all nodes "
        "about the lower left corner, anticlockwise, N), ux, uy (its way so far, m).",
    .options = reaction_options,
    .example =
        "p:clamp { edge = \"left\", depth = 2*mm, name = \"grip\" }\n"
        "s = simulate(p, { spacing = 1*mm }) s:run(1*us)\n"
        "print(s:reaction(\"grip\").fx)"};

void push_reaction(lua_State* L, const Reaction& one) {
  lua_createtable(L, 0, reaction_keys.size());
  close_names(L, "s.reactions", reaction_keys);
  push_text(L, one.name);
  lua_setfield(L, -2, "name");
  push_text(L, std::string(one.who));
  lua_setfield(L, -2, "body");
  set_integer(L, "number", one.number);
  set_number(L, "x", one.centre.x());
  set_number(L, "y", one.centre.y());
  set_number(L, "fx", one.force.x());
  set_number(L, "fy", one.force.y());
  set_number(L, "moment", one.moment);
  set_number(L, "ux", one.moved.x());
  set_number(L, "uy", one.moved.y());
}

[[noreturn]] void refuse_name(const std::string& name, const std::vector<Reaction>& all) {
  std::vector<std::string_view> known;
  known.reserve(all.size());
  for (const Reaction& one : all) known.push_back(one.name);
  throw Error(ErrorKind::refused,
              fmt::format("reaction: nothing that bears the plate is named '{}'{}", name,
                          did_you_mean(name, known)),
              known.empty() ? "give a clamp, a move, a roller or a foundation a name = \"...\""
                            : fmt::format("one of {}", comma_list(known)));
}

int reaction(lua_State* L) {
  const Simulation& simulation = self<ScriptedRun>(L, reaction_doc).results();
  const Arguments arguments = Arguments::from_values(L, 2, reaction_doc);
  arguments.problems.throw_if_any();
  const std::vector<Reaction> all = simulation.reactions();
  const std::string name = arguments.text("name");
  const auto found = std::ranges::find(all, name, &Reaction::name);
  if (found == all.end()) refuse_name(name, all);
  push_reaction(L, *found);
  return 1;
}

}  // namespace

int push_reactions(lua_State* L) {
  const std::vector<Reaction> all = object_at<ScriptedRun>(L, 1)->results().reactions();
  lua_createtable(L, static_cast<int>(all.size()), 0);
  lua_Integer place = 0;
  for (const Reaction& one : all) {
    push_reaction(L, one);
    lua_rawseti(L, -2, ++place);
  }
  return 1;
}

std::span<const Function> reaction_methods() {
  static constexpr std::array methods{Function{&reaction_doc, guarded<reaction>}};
  return methods;
}

}  // namespace hackle
