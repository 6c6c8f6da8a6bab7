// SPDX-License-Identifier: MIT
#include "console/load_binding.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "console/load_docs.hpp"
#include "console/plate_binding.hpp"
#include "console/plate_memory.hpp"
#include "console/simulation_binding.hpp"

namespace hackle {
namespace {

// A region that must be given.
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

// Each kind of load: how it is read, where it is kept, and which one it replaces.

struct TractionKind {
  static constexpr auto list = &Loads::tractions;
  static Traction read(Arguments& arguments, const Plate&) {
    return {arguments.choice<Edge>("edge"), arguments.vector_field("stress"),
            arguments.number("depth"), arguments.course("time")};
  }
  static bool same_place(const Traction& one, const Traction& other) {
    return one.edge == other.edge;
  }
};

struct PressureKind {
  static constexpr auto list = &Loads::pressures;
  static Pressure read(Arguments& arguments, const Plate&) {
    return {arguments.text("rim"), arguments.number("pressure"), arguments.course("time")};
  }
  static bool same_place(const Pressure& one, const Pressure& other) {
    return one.rim == other.rim;
  }
};

struct BodyForceKind {
  static constexpr auto list = &Loads::body_forces;
  static BodyForce read(Arguments& arguments, const Plate& plate) {
    return {region_of(arguments, plate, "body_force"), arguments.vector_field("force"),
            arguments.course("time")};
  }
  static bool same_place(const BodyForce& one, const BodyForce& other) {
    return one.region == other.region;
  }
};

struct ClampKind {
  static constexpr auto list = &Loads::supports;
  static Support read(Arguments& arguments, const Plate& plate) {
    Support support;
    support.region = required_region(arguments, plate, "clamp");
    support.kind = Support::Kind::velocity;  // it stays where it is, also in the middle of a run
    set_axes(arguments, support);
    return support;
  }
  static bool same_place(const Support& one, const Support& other) {
    return one.region == other.region && one.along_x == other.along_x &&
           one.along_y == other.along_y;
  }
};

struct MoveKind {
  static constexpr auto list = &Loads::supports;
  static Support read(Arguments& arguments, const Plate& plate) {
    Support support;
    support.region = required_region(arguments, plate, "move");
    const bool velocity = arguments.has("velocity"), displacement = arguments.has("displacement");
    if (velocity == displacement && arguments.good({"velocity", "displacement"}))
      arguments.problems.add("move: it is not clear how", "give velocity or displacement");
    support.kind = velocity ? Support::Kind::velocity : Support::Kind::displacement;
    support.value = arguments.vector_field(velocity ? "velocity" : "displacement");
    support.course = arguments.course("time");
    set_axes(arguments, support);
    return support;
  }
  static constexpr auto same_place = ClampKind::same_place;
};

struct TemperatureKind {
  static constexpr auto list = &Loads::heatings;
  static Heating read(Arguments& arguments, const Plate& plate) {
    return {region_of(arguments, plate, "temperature"), arguments.scalar_field("change"),
            arguments.course("time")};
  }
  static bool same_place(const Heating& one, const Heating& other) {
    return one.region == other.region;
  }
};

struct ImpactorKind {
  static constexpr auto list = &Loads::impactors;
  static Impactor read(Arguments& arguments, const Plate&) {
    Impactor impactor;
    impactor.centre = arguments.point("centre");
    impactor.radius = arguments.number("radius");
    impactor.velocity = arguments.pair("velocity");
    if (arguments.has("mass") && arguments.has("density"))
      arguments.problems.add("impactor: both a mass and a density are given", "give one of them");
    const double area = std::numbers::pi * impactor.radius * impactor.radius;
    impactor.mass = arguments.has("mass") ? arguments.number("mass")
                                          : area * arguments.number("density", steel);
    return impactor;
  }
  static bool same_place(const Impactor&, const Impactor&) { return false; }  // it is on its way

 private:
  static constexpr double steel = 7850.0;  // kg/m3
};

int return_self(lua_State* L) {
  lua_settop(L, 1);
  return 1;
}

template <class Kind, const FunctionDoc& doc>
int add_to_plate(lua_State* L) {
  Plate& plate = self<Plate>(L, doc);
  Arguments arguments = Arguments::from_table(L, 2, doc);
  auto load = Kind::read(arguments, plate);
  arguments.problems.throw_if_any();
  Loads loads = plate.loads;
  (loads.*Kind::list).push_back(std::move(load));
  check(loads, arguments.problems);
  arguments.problems.throw_if_any();
  plate.loads = std::move(loads);
  return return_plate(L);
}

template <class Kind, const FunctionDoc& doc>
int change_in_run(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, doc);
  Arguments arguments = Arguments::from_table(L, 2, doc);
  const Plate& plate = scripted.simulation().plate();
  auto load = Kind::read(arguments, plate);
  arguments.problems.throw_if_any();
  Loads loads = plate.loads;
  auto& list = loads.*Kind::list;
  std::erase_if(list, [&](const auto& other) { return Kind::same_place(load, other); });
  list.push_back(std::move(load));
  scripted.run().set_loads(std::move(loads));
  return return_self(L);
}

double read_damping(lua_State* L, const FunctionDoc& doc) {
  const Arguments arguments = Arguments::from_table(L, 2, doc);
  arguments.problems.throw_if_any();
  return arguments.number("rate");
}

int damp_plate(lua_State* L) {
  Plate& plate = self<Plate>(L, plate_damping_doc);
  plate.loads.damping = read_damping(L, plate_damping_doc);
  return return_plate(L);
}

int damp_run(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, run_damping_doc);
  Loads loads = scripted.simulation().plate().loads;
  loads.damping = read_damping(L, run_damping_doc);
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
                "name the area as clamp or move named it, or none for all");
  scripted.run().set_loads(std::move(loads));
  return return_self(L);
}

int add_start(lua_State* L) {
  Plate& plate = self<Plate>(L, start_doc);
  Arguments arguments = Arguments::from_table(L, 2, start_doc);
  Start start{region_of(arguments, plate, "start"), arguments.vector_field("displacement"),
              arguments.vector_field("velocity")};
  if (!arguments.has("displacement") && !arguments.has("velocity") &&
      arguments.good({"displacement", "velocity"}))
    arguments.problems.add("start: no motion is given", "give velocity, displacement or both");
  arguments.problems.throw_if_any();
  plate.starts.push_back(std::move(start));
  return return_plate(L);
}

constexpr std::array plate_methods{
    Function{&plate_traction_doc, guarded<add_to_plate<TractionKind, plate_traction_doc>>},
    Function{&plate_pressure_doc, guarded<add_to_plate<PressureKind, plate_pressure_doc>>},
    Function{&plate_body_force_doc, guarded<add_to_plate<BodyForceKind, plate_body_force_doc>>},
    Function{&plate_clamp_doc, guarded<add_to_plate<ClampKind, plate_clamp_doc>>},
    Function{&plate_move_doc, guarded<add_to_plate<MoveKind, plate_move_doc>>},
    Function{&plate_temperature_doc, guarded<add_to_plate<TemperatureKind, plate_temperature_doc>>},
    Function{&plate_impactor_doc, guarded<add_to_plate<ImpactorKind, plate_impactor_doc>>},
    Function{&plate_damping_doc, guarded<damp_plate>},
    Function{&start_doc, guarded<add_start>},
};

constexpr std::array simulation_methods{
    Function{&run_traction_doc, guarded<change_in_run<TractionKind, run_traction_doc>>},
    Function{&run_pressure_doc, guarded<change_in_run<PressureKind, run_pressure_doc>>},
    Function{&run_body_force_doc, guarded<change_in_run<BodyForceKind, run_body_force_doc>>},
    Function{&run_clamp_doc, guarded<change_in_run<ClampKind, run_clamp_doc>>},
    Function{&run_move_doc, guarded<change_in_run<MoveKind, run_move_doc>>},
    Function{&run_temperature_doc, guarded<change_in_run<TemperatureKind, run_temperature_doc>>},
    Function{&run_impactor_doc, guarded<change_in_run<ImpactorKind, run_impactor_doc>>},
    Function{&run_damping_doc, guarded<damp_run>},
    Function{&release_doc, guarded<release>},
};

void push_course(lua_State* L, const Course& course) {
  lua_createtable(L, static_cast<int>(course.points().size()), 0);
  lua_Integer place = 0;
  for (const Vec2& point : course.points()) {
    lua_createtable(L, 2, 0);
    lua_pushnumber(L, point.x());
    lua_rawseti(L, -2, 1);
    lua_pushnumber(L, point.y());
    lua_rawseti(L, -2, 2);
    lua_rawseti(L, -2, ++place);
  }
}

template <const FunctionDoc& doc, Course (*make)(const Arguments&)>
int push(lua_State* L) {
  const Arguments arguments = Arguments::from_values(L, 1, doc);
  arguments.problems.throw_if_any();
  push_course(L, make(arguments));
  return 1;
}

Course make_ramp(const Arguments& arguments) {
  return ramp(arguments.number("duration"));
}
Course make_pulse(const Arguments& arguments) {
  return pulse(arguments.number("duration"), arguments.number("start"));
}
Course make_step(const Arguments& arguments) {
  return step_at(arguments.number("start"));
}

constexpr std::array courses{
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

std::span<const Function> course_functions() {
  return courses;
}

}  // namespace hackle
