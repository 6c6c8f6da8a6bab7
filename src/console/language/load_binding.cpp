// SPDX-License-Identifier: MIT
#include "console/language/load_binding.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/text.hpp"
#include "console/language/load_docs.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/language/scripted_run.hpp"
#include "console/schema/object_type.hpp"
#include "scene/load_names.hpp"

namespace hackle {
namespace {

// Returns a region that must be given.
Region required_region(Arguments& arguments, const Plate& plate, std::string_view who) {
  Region region = region_of(arguments, plate, who);
  if (!region && arguments.problems.empty())
    arguments.problems.add(std::string(who) + ": no area is given",
                           "give edge and depth, or from and to, or centre and radius");
  return region;
}

void set_axes(const Arguments& arguments, Support& support) {
  const auto axis = arguments.text_of_choice("axis", "both");
  support.along_x = axis != "y";
  support.along_y = axis != "x";
}

void check_guide(Arguments& arguments, const FunctionDoc& doc) {
  const auto given = std::ranges::count_if(
      enum_names<Guide>, [&](std::string_view name) { return arguments.has(name); });
  if (given > 1)
    arguments.problems.add(
        fmt::format("{}: more than one of {} is given", doc.name, comma_list(enum_names<Guide>)),
        "give one of them");
  if (arguments.has("mass") && !arguments.has("force") && arguments.good({"force"}))
    arguments.problems.add(fmt::format("{}: a mass goes with a force", doc.name),
                           "leave it out, or give a force");
}

// Sets what a description cannot say: regions, axes, members with another option name.

template <class Load>
void complete(Load& load, Arguments& arguments, const Plate& plate, const FunctionDoc& doc) {
  if constexpr (requires { load.region; }) load.region = region_of(arguments, plate, doc.name);
  if constexpr (requires { load.guided; }) check_guide(arguments, doc);
}

// A clamp prescribes velocity 0: the nodes stay where they are, even in the middle of a run.
void complete(Support& support, Arguments& arguments, const Plate& plate, const FunctionDoc& doc) {
  support.region = required_region(arguments, plate, doc.name);
  set_axes(arguments, support);
  if (!arguments.takes("velocity")) {
    support.kind = Support::Kind::velocity;
    return;
  }
  if (arguments.has("velocity") == arguments.has("displacement") &&
      arguments.good({"velocity", "displacement"}))
    arguments.problems.add("move: it is not clear how", "give velocity or displacement");
}

void complete(Impactor& impactor, Arguments& arguments, const Plate&, const FunctionDoc&) {
  if (arguments.has("mass") && arguments.has("density"))
    arguments.problems.add("impactor: both a mass and a density are given", "give one of them");
  const double area = std::numbers::pi * impactor.radius * impactor.radius;
  if (!arguments.has("mass")) impactor.mass = area * arguments.number("density", density_of_steel);
}

template <class Load>
Load load_of(Arguments& arguments, const Plate& plate, const FunctionDoc& doc) {
  auto load = noun_of<Load>(arguments);
  complete(load, arguments, plate, doc);
  arguments.problems.throw_if_any();
  return load;
}

int return_self(lua_State* L) {
  lua_settop(L, 1);
  return 1;
}

template <class Load, const FunctionDoc& doc>
int add_to_plate(lua_State* L) {
  Plate& plate = self<Plate>(L, doc);
  Arguments arguments = Arguments::from_table(L, 2, doc);
  Loads loads = plate.loads;
  all_of<Load>(loads).push_back(load_of<Load>(arguments, plate, doc));
  check(loads, arguments.problems);
  check_load_names(loads, arguments.problems);
  arguments.problems.throw_if_any();
  plate.loads = std::move(loads);
  return return_plate(L);
}

// Replaces the load at the same place by one that comes last: it has the last word where loads
// exclude each other. The state knows guided bodies by their number, which they keep.
template <class Load>
void put_in_place(Load load, std::vector<Load>& list) {
  const auto is_there = [&](const Load& other) { return same_place(load, other); };
  if constexpr (requires { load.guided; }) {
    const auto found = std::ranges::find_if(list, is_there);
    if (found != list.end()) {
      *found = std::move(load);
      return;
    }
  }
  std::erase_if(list, is_there);
  list.push_back(std::move(load));
}

template <class Load, const FunctionDoc& doc>
int change_in_run(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, doc);
  Arguments arguments = Arguments::from_table(L, 2, doc);
  const Plate& plate = scripted.simulation().plate();
  auto load = load_of<Load>(arguments, plate, doc);
  Loads loads = plate.loads;
  std::vector<Load>& list = all_of<Load>(loads);
  put_in_place(std::move(load), list);
  scripted.run().set_loads(std::move(loads));
  return return_self(L);
}

// What is not given is 0 from then on.
void read_damping(lua_State* L, const FunctionDoc& doc, Loads& loads) {
  Arguments arguments = Arguments::from_table(L, 2, doc);
  if (!arguments.has("rate") && !arguments.has("stiffness") &&
      arguments.good({"rate", "stiffness"}))
    arguments.problems.add("damping: it is not clear how much", "give rate, stiffness or both");
  arguments.problems.throw_if_any();
  loads.damping = arguments.number("rate", 0.0);
  loads.stiffness_damping = arguments.number("stiffness", 0.0);
}

int damp_plate(lua_State* L) {
  Plate& plate = self<Plate>(L, plate_damping_doc);
  read_damping(L, plate_damping_doc, plate.loads);
  return return_plate(L);
}

int damp_run(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, run_damping_doc);
  Loads loads = scripted.simulation().plate().loads;
  read_damping(L, run_damping_doc, loads);
  scripted.run().set_loads(std::move(loads));
  return return_self(L);
}

int release(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, release_doc);
  Arguments arguments = Arguments::from_table(L, 2, release_doc);
  const Plate& plate = scripted.simulation().plate();
  const Region region = region_of(arguments, plate, "release");
  arguments.problems.throw_if_any();
  Loads loads = plate.loads;
  const auto gone = std::erase_if(
      loads.supports, [&](const Support& support) { return !region || support.region == region; });
  if (gone == 0)
    throw Error(ErrorKind::refused, "release: nothing is clamped or moved there",
                "give the same area as for clamp or move, or none for all");
  scripted.run().set_loads(std::move(loads));
  return return_self(L);
}

int add_start(lua_State* L) {
  Plate& plate = self<Plate>(L, plate_start_doc);
  Arguments arguments = Arguments::from_table(L, 2, plate_start_doc);
  auto start = noun_of<InitialCondition>(arguments);
  start.region = region_of(arguments, plate, "initial");
  if (!arguments.has("displacement") && !arguments.has("velocity") &&
      arguments.good({"displacement", "velocity"}))
    arguments.problems.add("initial: no motion is given", "give velocity, displacement or both");
  arguments.problems.throw_if_any();
  plate.initial_conditions.push_back(std::move(start));
  return return_plate(L);
}

template <class Member>
constexpr bool introduces_itself = false;
template <class Load>
constexpr bool introduces_itself<std::vector<Load>> = !introduction_of<Load>.sentence.empty();

// The functions of all loads that introduce themselves: Bind<Load>::function of each.
template <template <class> class Bind>
constexpr auto introduced_loads() {
  constexpr auto for_each = [](const auto& visit) {
    for_each_member<Loads>([&](const auto& list) {
      using List = typename std::remove_cvref_t<decltype(list)>::Value;
      if constexpr (introduces_itself<List>) visit(std::type_identity<typename List::value_type>());
    });
  };
  constexpr std::size_t count = [=] {
    std::size_t sum = 0;
    for_each([&](auto) { ++sum; });
    return sum;
  }();
  std::array<Function, count> all;
  std::size_t next = 0;
  for_each([&]<class Load>(std::type_identity<Load>) { all[next++] = Bind<Load>::function; });
  return all;
}

template <class Load>
struct OnPlate {
  static constexpr Function function{&plate_load_doc<Load>,
                                     guarded<add_to_plate<Load, plate_load_doc<Load>>>};
};
template <class Load>
struct InRun {
  static constexpr Function function{&run_load_doc<Load>,
                                     guarded<change_in_run<Load, run_load_doc<Load>>>};
};

constexpr std::array own_plate_methods{
    Function{&plate_traction_doc, guarded<add_to_plate<Traction, plate_traction_doc>>},
    Function{&plate_pressure_doc, guarded<add_to_plate<Pressure, plate_pressure_doc>>},
    Function{&plate_body_force_doc, guarded<add_to_plate<BodyForce, plate_body_force_doc>>},
    Function{&plate_clamp_doc, guarded<add_to_plate<Support, plate_clamp_doc>>},
    Function{&plate_move_doc, guarded<add_to_plate<Support, plate_move_doc>>},
    Function{&plate_temperature_doc, guarded<add_to_plate<ThermalLoad, plate_temperature_doc>>},
    Function{&plate_impactor_doc, guarded<add_to_plate<Impactor, plate_impactor_doc>>},
    Function{&plate_damping_doc, guarded<damp_plate>},
    Function{&plate_start_doc, guarded<add_start>},
};

constexpr auto plate_methods = joined(own_plate_methods, introduced_loads<OnPlate>());

constexpr std::array own_simulation_methods{
    Function{&run_traction_doc, guarded<change_in_run<Traction, run_traction_doc>>,
             Replayed::declares},
    Function{&run_pressure_doc, guarded<change_in_run<Pressure, run_pressure_doc>>,
             Replayed::declares},
    Function{&run_body_force_doc, guarded<change_in_run<BodyForce, run_body_force_doc>>,
             Replayed::declares},
    Function{&run_clamp_doc, guarded<change_in_run<Support, run_clamp_doc>>, Replayed::declares},
    Function{&run_move_doc, guarded<change_in_run<Support, run_move_doc>>, Replayed::declares},
    Function{&run_temperature_doc, guarded<change_in_run<ThermalLoad, run_temperature_doc>>,
             Replayed::declares},
    Function{&run_impactor_doc, guarded<change_in_run<Impactor, run_impactor_doc>>,
             Replayed::declares},
    Function{&run_damping_doc, guarded<damp_run>, Replayed::declares},
    Function{&release_doc, guarded<release>, Replayed::declares},
};

constexpr auto simulation_methods = joined(own_simulation_methods, introduced_loads<InRun>());

void push_amplitude(lua_State* L, const Amplitude& amplitude) {
  lua_createtable(L, static_cast<int>(amplitude.points().size()), 0);
  lua_Integer place = 0;
  for (const Vec2& point : amplitude.points()) {
    lua_createtable(L, 2, 0);
    lua_pushnumber(L, point.x());
    lua_rawseti(L, -2, 1);
    lua_pushnumber(L, point.y());
    lua_rawseti(L, -2, 2);
    lua_rawseti(L, -2, ++place);
  }
}

template <const FunctionDoc& doc, Amplitude (*make)(const Arguments&)>
int push(lua_State* L) {
  const Arguments arguments = Arguments::from_values(L, 1, doc);
  arguments.problems.throw_if_any();
  push_amplitude(L, make(arguments));
  return 1;
}

Amplitude make_ramp(const Arguments& arguments) {
  return ramp(arguments.number("duration"));
}
Amplitude make_pulse(const Arguments& arguments) {
  return pulse(arguments.number("duration"), arguments.number("start"));
}
Amplitude make_step(const Arguments& arguments) {
  return step_at(arguments.number("start"));
}

constexpr std::array amplitudes{
    Function{&ramp_doc, guarded<push<ramp_doc, make_ramp>>},
    Function{&pulse_doc, guarded<push<pulse_doc, make_pulse>>},
    Function{&step_at_doc, guarded<push<step_at_doc, make_step>>},
};

}  // namespace

std::span<const Function> load_methods_of_plate() {
  return plate_methods;
}

std::span<const Function> load_methods_of_simulation() {
  return simulation_methods;
}

std::span<const Function> amplitude_functions() {
  return amplitudes;
}

}  // namespace hackle
