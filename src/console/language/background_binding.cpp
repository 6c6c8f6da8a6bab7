// SPDX-License-Identifier: MIT
#include "console/language/background_binding.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "base/files.hpp"
#include "console/language/scripted_run.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/schema/result_table.hpp"

namespace hackle {
namespace {

constexpr const char* known_key = "hackle.simulations by number";
constexpr const char* held_key = "hackle.simulations under way";

constexpr std::array background_options{
    Option{.name = "duration",
           .unit = "s",
           .range = at_least(0.0),
           .required = true,
           .sentence = "Simulated time from now, or from the end of the current run."},
};
constexpr FunctionDoc start_doc{.name = "start",
                                .owner = "s",
                                .call = Call::values,
                                .sentence =
                                    "Runs like run, but in the background, while the prompt waits "
                                    "for the next line; a script waits for it at its end.",
                                .options = background_options,
                                .example = "s:start(2*us) s:wait()"};

constexpr FunctionDoc status_doc{
    .name = "status",
    .owner = "s",
    .call = Call::values,
    .sentence =
        "Returns a table: state (idle, running, paused), time and until (s), steps, broken_bonds.",
    .example = "print(s:status().state)"};

constexpr FunctionDoc pause_doc{.name = "pause",
                                .owner = "s",
                                .call = Call::values,
                                .sentence = "Pauses a started run until resume.",
                                .example = "s:start(2*us) s:pause() s:resume()"};

constexpr FunctionDoc resume_doc{
    .name = "resume",
    .owner = "s",
    .call = Call::values,
    .sentence = "Continues a run that was paused, or interrupted in wait.",
    .example = "s:start(2*us) s:pause() s:resume()"};

constexpr Option steps_option{.name = "steps",
                              .type = OptionType::integer,
                              .range = at_least(0.0),
                              .alternative = true,
                              .sentence = "Waits only until it has taken this many steps in all."};
constexpr std::array wait_options{steps_option};
constexpr FunctionDoc wait_doc{.name = "wait",
                               .owner = "s",
                               .sentence = "Waits for a started run to finish; Ctrl-C pauses it.",
                               .options = wait_options,
                               .example = "s:start(2*us) s:wait()"};

constexpr std::array interrupt_options{
    Option{.name = "steps",
           .type = OptionType::integer,
           .range = at_least(0.0),
           .required = true,
           .sentence = "Number of steps in all after which it interrupts."},
};
constexpr FunctionDoc interrupt_doc{
    .name = "interrupt",
    .owner = "s",
    .sentence =
        "Interrupts the next run once, as Ctrl-C would; scripts written by s:script need it.",
    .options = interrupt_options,
    .example = "s:interrupt { steps = 3 } pcall(s.run, s, 2*us)"};

constexpr std::array script_options{
    Option{.name = "file",
           .type = OptionType::text,
           .required = true,
           .positional = true,
           .sentence = "File name, ending in .lua."},
};
constexpr FunctionDoc script_doc{
    .name = "script",
    .owner = "s",
    .sentence = "Writes a script that repeats everything typed so far, to the bit.",
    .options = script_options,
    .example = "s:script { \"typed.lua\" }"};

constexpr FunctionDoc simulations_doc{
    .name = "simulations",
    .call = Call::values,
    .sentence =
        "Returns all simulations still in use, indexed by the order in which they were made.",
    .example = "print(simulations()[1])"};

template <const FunctionDoc& doc>
Run& checked_run(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, doc);
  Arguments::from_values(L, 2, doc).problems.throw_if_any();
  return scripted.run();
}

// [-0, +1] Pushes a table of the registry, made on first use.
void push_kept(lua_State* L, const char* key, bool weak) {
  if (luaL_getsubtable(L, LUA_REGISTRYINDEX, key) != 0 || !weak) return;
  lua_createtable(L, 0, 1);
  push_text(L, "v");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
}

void keep(lua_State* L, int index, const char* key, bool weak) {
  const int object = lua_absindex(L, index);
  const ScriptedRun& scripted = *object_at<ScriptedRun>(L, object);
  push_kept(L, key, weak);
  lua_pushvalue(L, object);
  lua_rawseti(L, -2, session_of(L).number_of(scripted.run()));
  lua_pop(L, 1);
}

// Releases the runs that have finished.
void release_arrived(lua_State* L) {
  push_kept(L, held_key, false);
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    const ScriptedRun* scripted = object_at<ScriptedRun>(L, -1);
    if (scripted != nullptr && scripted->run().under_way()) continue;
    lua_pushvalue(L, -2);
    lua_pushnil(L);
    lua_rawset(L, -5);
  }
  lua_pop(L, 1);
}

int start(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, start_doc);
  const Arguments arguments = Arguments::from_values(L, 2, start_doc);
  arguments.problems.throw_if_any();
  scripted.check_still_writable();
  scripted.run().start(arguments.number("duration"));
  keep(L, 1, held_key, false);
  return 0;
}

constexpr auto status_names =
    std::to_array<std::string_view>({"state", "time", "until", "steps", "broken_bonds"});

const char* state_word(const Run& run) {
  if (!run.under_way()) return "idle";
  return run.paused() ? "paused" : "running";
}

int status(lua_State* L) {
  const Run& run = checked_run<status_doc>(L);
  const Simulation& simulation = run.simulation();
  lua_createtable(L, 0, status_names.size());
  close_names(L, "s:status()", status_names);
  push_text(L, state_word(run));
  lua_setfield(L, -2, "state");
  set_number(L, "time", simulation.time());
  set_number(L, "until", std::max(simulation.end_time(), simulation.time()));
  set_integer(L, "steps", simulation.state().step);
  set_integer(L, "broken_bonds", count_damage(simulation).broken_bonds);
  return 1;
}

int pause(lua_State* L) {
  checked_run<pause_doc>(L).pause();
  return 0;
}

int resume(lua_State* L) {
  checked_run<resume_doc>(L).resume();
  return 0;
}

int wait(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, wait_doc);
  const Arguments arguments = Arguments::from_table(L, 2, wait_doc);
  arguments.problems.throw_if_any();
  std::optional<std::int64_t> steps;
  if (arguments.has("steps")) steps = arguments.integer("steps");
  scripted.run().wait(steps);
  return 0;
}

int interrupt(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, interrupt_doc);
  const Arguments arguments = Arguments::from_table(L, 2, interrupt_doc);
  arguments.problems.throw_if_any();
  scripted.run().interrupt_at(arguments.integer("steps"));
  return 0;
}

int script(lua_State* L) {
  self<ScriptedRun>(L, script_doc);
  const Arguments arguments = Arguments::from_table(L, 2, script_doc);
  arguments.problems.throw_if_any();
  Session& session = session_of(L);
  const auto path = session.claim("script", arguments.text("file"), FileKind::script);
  if (session.settings.purpose != Purpose::results) return 0;
  make_folder_of(path);
  write_text(path, session.script());
  return 0;
}

int list(lua_State* L) {
  Arguments::from_values(L, 1, simulations_doc).problems.throw_if_any();
  lua_newtable(L);
  push_kept(L, known_key, true);
  for (lua_pushnil(L); lua_next(L, -2) != 0;) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -5);
  }
  lua_pop(L, 1);
  return 1;
}

}  // namespace

std::span<const Function> background_methods() {
  static constexpr std::array methods{
      Function{&start_doc, guarded<start>, Replayed::declares},
      Function{&status_doc, guarded<status>},
      Function{&pause_doc, guarded<pause>, Replayed::declares},
      Function{&resume_doc, guarded<resume>, Replayed::declares},
      Function{&wait_doc, guarded<wait>, Replayed::advances},
      Function{&script_doc, guarded<script>},
      Function{&interrupt_doc, guarded<interrupt>, Replayed::declares},
  };
  return methods;
}

std::span<const Function> background_functions() {
  static constexpr std::array functions{Function{&simulations_doc, guarded<list>}};
  return functions;
}

void remember_simulation(lua_State* L, int index) {
  keep(L, index, known_key, true);
}

void collect_simulations(lua_State* L) {
  release_arrived(L);
  lua_gc(L, LUA_GCCOLLECT);
}

}  // namespace hackle
