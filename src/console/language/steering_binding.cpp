// SPDX-License-Identifier: MIT
#include "console/language/steering_binding.hpp"

#include <array>
#include <memory>

#include <fmt/format.h>

#include "console/language/background_binding.hpp"
#include "console/language/region_options.hpp"
#include "console/language/scripted_run.hpp"
#include "console/language/watcher.hpp"
#include "console/lua/description.hpp"
#include "console/replay/replayed_observer.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"

namespace hackle {
namespace {

enum class Event { every, breaks, damage, nucleation, branch, coalescence, arrest, arrival };
constexpr auto event_names = std::to_array<std::string_view>(
    {"every", "break", "damage", "nucleation", "branch", "coalescence", "arrest", "arrival"});

constexpr auto on_options = joined(
    std::array{Option{.name = "event",
                      .type = OptionType::choice,
                      .required = true,
                      .positional = true,
                      .choices = event_names,
                      .sentence = "Event: every (repeatedly), break (once, when the next bond "
                                  "breaks), damage (once, when a crack reaches an area), or each "
                                  "nucleation, branch, coalescence, arrest or arrival (at an edge "
                                  "or hole) of cracks, see s:graph."},
               Option{.name = "call",
                      .type = OptionType::function,
                      .required = true,
                      .sentence = "Function called with the time, between two steps; it may change "
                                  "loads, write pictures, and stop the run. An event of cracks "
                                  "is seen some time after it: s:graph().events has its time and "
                                  "place."},
               Option{.name = "every",
                      .unit = "s",
                      .range = above(0.0),
                      .alternative = true,
                      .sentence = "Simulated time between calls, for every."},
               Option{.name = "above",
                      .range = between(0.0, 1.0),
                      .fallback = "0.35",
                      .sentence = "Damage that a node of the area must exceed, for damage; 0.35 is "
                                  "the side of a crack."}},
    region_options);

constexpr FunctionDoc on_doc{
    .name = "on",
    .owner = "s",
    .sentence = "Calls a function between steps when an event occurs.",
    .options = on_options,
    .example =
        "s:on { \"every\", every = 1*us, call = function(t) print(t, s.energy.kinetic) end }\n"
        "s:on { \"damage\", from = {80*mm, 0}, to = {100*mm, 40*mm}, call = function() s:stop() "
        "end }\n"
        "s:on { \"branch\", call = function(t) print(#s:tips(), t) end }"};
constexpr FunctionDoc stop_doc{
    .name = "stop",
    .owner = "s",
    .call = Call::values,
    .sentence = "Ends the current run; in a function given to s:on, after this step.",
    .example = "s:on { \"break\", call = function() s:stop() end }"};
constexpr FunctionDoc fork_doc{
    .name = "fork",
    .owner = "s",
    .call = Call::values,
    .sentence = "Returns a copy in the same state, which can go another way.",
    .example = "t = s:fork()"};
constexpr FunctionDoc rewind_doc{
    .name = "rewind",
    .owner = "s",
    .leading = "t",
    .call = Call::values,
    .sentence =
        "Returns to, or takes over, the state and loads of another simulation of the same plate.",
    .example = "t = s:fork() s:run(1*us) s:rewind(t)"};

// Checks the options that belong to one event only.
void check_event(const Arguments& arguments, Event event, Problems& problems) {
  if (!arguments.good({"event"})) return;
  if (event == Event::every && !arguments.has("every") && arguments.good({"every"}))
    problems.add("on: every is missing (a number in s)",
                 "as in on { \"every\", every = 1*us, ... }");
  if (event != Event::every && arguments.has("every"))
    problems.add(
        fmt::format("on: every does not go with {}", event_names[static_cast<std::size_t>(event)]));
}

std::shared_ptr<Observer> watcher_of(const Arguments& arguments, Event event, const Region& area,
                                     const Simulation& simulation) {
  LuaFunction function = arguments.function("call");
  if (event == Event::every)
    return std::make_shared<Ticker>(std::move(function), arguments.number("every"), simulation);
  if (event == Event::breaks) return std::make_shared<BreakAlarm>(std::move(function), simulation);
  if (event >= Event::nucleation) {
    const int kind = static_cast<int>(event) - static_cast<int>(Event::nucleation);
    return std::make_shared<CrackAlarm>(std::move(function), static_cast<CrackEventKind>(kind),
                                        simulation);
  }
  return std::make_shared<DamageAlarm>(std::move(function), area, arguments.number("above", 0.35),
                                       simulation);
}

int on(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, on_doc);
  Arguments arguments = Arguments::from_table(L, 2, on_doc);
  const Event event = arguments.choice<Event>("event");
  const Region area = region_of(arguments, scripted.simulation().plate(), "on");
  check_event(arguments, event, arguments.problems);
  arguments.problems.throw_if_any();
  scripted.run().doubt("a function that s:on calls may change loads");
  std::shared_ptr<Observer> watcher = watcher_of(arguments, event, area, scripted.simulation());
  if (const auto& checkpoints = session_of(L).checkpoints)
    watcher = std::make_shared<ReplayedObserver>(std::move(watcher), checkpoints->replay(),
                                                 scripted.run());
  scripted.run().watch(std::move(watcher));
  return 0;
}

int stop(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, stop_doc);
  Arguments::from_values(L, 2, stop_doc).problems.throw_if_any();
  scripted.run().stop();
  return 0;
}

int fork(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, fork_doc);
  Arguments::from_values(L, 2, fork_doc).problems.throw_if_any();
  Session& session = session_of(L);
  collect_simulations(L);
  session.check_memory("fork", scripted.simulation().bytes());
  push_object(L, ScriptedRun(session.adopt(scripted.run().fork()), session));
  remember_simulation(L, -1);
  return 1;
}

int rewind(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, rewind_doc);
  const ScriptedRun* other = object_at<ScriptedRun>(L, 2);
  if (other == nullptr)
    throw Error(ErrorKind::refused,
                fmt::format("rewind: expected a simulation, got {}", description(L, 2)),
                fmt::format("as in {}", rewind_doc.example));
  scripted.run().rewind(other->run());
  return 0;
}

}  // namespace

std::span<const Function> steering_methods() {
  static constexpr std::array methods{Function{&on_doc, guarded<on>, Replayed::declares},
                                      Function{&stop_doc, guarded<stop>, Replayed::declares},
                                      Function{&fork_doc, guarded<fork>, Replayed::declares},
                                      Function{&rewind_doc, guarded<rewind>, Replayed::declares}};
  return methods;
}

}  // namespace hackle
