// SPDX-License-Identifier: MIT
#include "console/language/simulation_binding.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "base/terminal.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "console/language/background_binding.hpp"
#include "console/language/chart_binding.hpp"
#include "console/language/checkpoint_binding.hpp"
#include "console/language/error_budget.hpp"
#include "console/language/fracture_binding.hpp"
#include "console/language/gauge_binding.hpp"
#include "console/language/graph_binding.hpp"
#include "console/language/load_binding.hpp"
#include "console/language/measure_binding.hpp"
#include "console/language/overrides.hpp"
#include "console/language/reaction_binding.hpp"
#include "console/language/relax_binding.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/language/scripted_run.hpp"
#include "console/language/series_binding.hpp"
#include "console/language/show_binding.hpp"
#include "console/language/simulation_docs.hpp"
#include "console/language/steering_binding.hpp"
#include "console/language/values_binding.hpp"
#include "console/lua/description.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/schema/result_table.hpp"
#include "lattice/check_numerics.hpp"
#include "lattice/needs.hpp"
#include "scene/waves.hpp"

namespace hackle {
namespace {

const Plate& plate_at(lua_State* L, int index) {
  if (const Plate* plate = object_at<Plate>(L, index)) return *plate;
  throw Error(ErrorKind::refused,
              fmt::format("simulate: expected a plate first, got {}", description(L, index)),
              fmt::format("as in {}", simulate_doc.example));
}

// Wrong options were read as their defaults; the step limit is then not that of the intended
// lattice.
void check_numerics(const Plate& plate, Numerics numerics, std::uint64_t memory,
                    Arguments& arguments) {
  if (!arguments.has("spacing")) return;
  if (!arguments.good({"horizon", "quadrature", "micromodulus", "constants", "surface"}))
    numerics.step.reset();
  check(plate, numerics, memory, arguments.problems);
}

int simulate(lua_State* L) {
  Session& session = session_of(L);
  if (session.settings.purpose == Purpose::options) session.leave(0);  // it declares none
  session.check_overrides_used();
  Plate plate = plate_at(L, 1);
  set_overrides(L, 2, simulate_prefix, session);
  const std::optional<ErrorBudget> budget = spend_budget(L, 2, plate, session);
  Arguments arguments = Arguments::from_table(L, 2, simulate_doc);
  override_material(L, session, plate.material, arguments.problems);
  override_scatter(L, session, plate, arguments.problems);
  const Numerics numerics = noun_of<Numerics>(arguments);
  check(plate, arguments.problems);
  collect_simulations(L);
  check_numerics(plate, numerics, session.memory_left(), arguments);
  arguments.problems.throw_if_any();
  const std::shared_ptr<Run> run = session.simulate(std::move(plate), numerics);
  if (budget) run->set_budget(*budget);
  push_object(L, ScriptedRun(run, session));
  remember_simulation(L, -1);
  return 1;
}

int run(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, run_doc);
  const Arguments arguments = Arguments::from_values(L, 2, run_doc);
  arguments.problems.throw_if_any();
  scripted.check_still_writable();
  scripted.run().run(arguments.number("duration"));
  return 0;
}

int step(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, step_doc);
  const Arguments arguments = Arguments::from_values(L, 2, step_doc);
  arguments.problems.throw_if_any();
  scripted.check_still_writable();
  scripted.run().step(arguments.integer("count", 1));
  return 0;
}

int movie(lua_State* L) {
  ScriptedRun& scripted = self<ScriptedRun>(L, movie_doc);
  set_overrides(L, 2, movie_prefix, session_of(L));
  const Arguments arguments = Arguments::from_table(L, 2, movie_doc);
  arguments.problems.throw_if_any();
  if (session_of(L).settings.only_verdicts) return 0;
  const auto path = session_of(L).output_path("movie", arguments.text("file"));
  scripted.promised.push_back(scripted.run().movie(path, noun_of<MovieOptions>(arguments)));
  return 0;
}

int frame(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, frame_doc);
  const Arguments arguments = Arguments::from_table(L, 2, frame_doc);
  arguments.problems.throw_if_any();
  if (session_of(L).settings.no_pictures) return 0;
  scripted.run().frame(session_of(L).output_path("frame", arguments.text("file")),
                       noun_of<PictureOptions>(arguments));
  return 0;
}

int record(lua_State* L) {
  ScriptedRun& scripted = self<ScriptedRun>(L, record_doc);
  Arguments arguments = Arguments::from_table(L, 2, record_doc);
  auto options = noun_of<RecordOptions>(arguments);
  options.region = region_of(arguments, scripted.simulation().plate(), "record");
  arguments.problems.throw_if_any();
  if (session_of(L).settings.no_pictures) return 0;
  const auto path = session_of(L).output_path("record", arguments.text("file"));
  scripted.run().record(path, options);
  scripted.promised.push_back(path);
  return 0;
}

// Breaks lines of a report at blanks; what continues stands below what began beside its label.
std::string table_in_columns(const std::string& text, std::size_t columns) {
  constexpr std::size_t label = 11;
  std::istringstream lines(text);
  std::string fitted;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t head = line.starts_with("  ") ? std::min(label, line.size()) : 0;
    fitted += fmt::format("{}{}{}", fitted.empty() ? "" : "\n", line.substr(0, head),
                          hanging(line.substr(head), head, std::max(columns, 2 * label)));
  }
  return fitted;
}

int report(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, report_doc);
  Arguments::from_values(L, 2, report_doc).problems.throw_if_any();
  const std::string text = scripted.run().report();
  const bool seen = session_of(L).settings.show_in_terminal;
  push_text(L, seen ? table_in_columns(text, terminal_columns(STDOUT_FILENO)) : text);
  return 1;
}

int close(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, close_doc);
  Arguments::from_values(L, 2, close_doc).problems.throw_if_any();
  scripted.run().close();
  return 0;
}

constexpr std::array own_methods_of_simulation{
    Function{&run_doc, guarded<run>, Replayed::runs},
    Function{&step_doc, guarded<step>, Replayed::runs},
    Function{&movie_doc, guarded<movie>, Replayed::declares},
    Function{&frame_doc, guarded<frame>},
    Function{&record_doc, guarded<record>, Replayed::declares},
    Function{&report_doc, guarded<report>},
    Function{&close_doc, guarded<close>, Replayed::declares}};

// Returns 371 234 as "371 k", for reading at a glance.
std::string rounded_count(std::int64_t count) {
  constexpr std::int64_t exact_below = 100000;
  if (count < exact_below) return grouped(count);
  if (count < 1000 * exact_below)
    return grouped(std::llround(1e-3 * static_cast<double>(count))) + " k";
  return grouped(std::llround(1e-6 * static_cast<double>(count))) + " M";
}

int simulation_to_text(lua_State* L) {
  const Simulation& simulation = object_at<ScriptedRun>(L, 1)->simulation();
  const Numerics& numerics = simulation.numerics();
  std::string text =
      fmt::format("{} nodes, {} bonds, horizon {} (m = {:.4g}), step {} (limit {}), {}",
                  grouped(static_cast<std::int64_t>(simulation.lattice().grid.nodes())),
                  rounded_count(simulation.lattice().initial_bonds()),
                  quantity(numerics.horizon_or_default(), "m"), numerics.m(),
                  quantity(simulation.dt(), "s"), quantity(simulation.lattice().step_limit, "s"),
                  quantity(memory_of(simulation.plate(), numerics).all(), "B"));
  if (simulation.state().step > 0)
    text += fmt::format("; at {}, step {}", quantity(simulation.time(), "s"),
                        grouped(simulation.state().step));
  push_text(L, text);
  return 1;
}

const Simulation& simulation_of(lua_State* L) {
  return object_at<ScriptedRun>(L, 1)->simulation();
}

const Simulation& results_of(lua_State* L) {
  return object_at<ScriptedRun>(L, 1)->results();
}

// What the report says of the plate's own material on the lattice.
double spacing_of(const Simulation& simulation) {
  return simulation.numerics().spacing;
}
double horizon_of(const Simulation& simulation) {
  return simulation.numerics().horizon_or_default();
}
double m_of(const Simulation& simulation) {
  return simulation.numerics().m();
}
double E_of(const Simulation& simulation) {
  return simulation.lattice().calibration.moduli.E;
}
double nu_of(const Simulation& simulation) {
  return simulation.lattice().calibration.moduli.nu;
}
double G0_of(const Simulation& simulation) {
  return simulation.lattice().calibration.G0;
}
double s0_of(const Simulation& simulation) {
  return simulation.lattice().calibration.s0;
}
WaveSpeeds waves_of(const Simulation& simulation) {
  return wave_speeds(E_of(simulation), nu_of(simulation), simulation.lattice().rho,
                     simulation.plate().plane);
}
double c_L_of(const Simulation& simulation) {
  return waves_of(simulation).longitudinal;
}
double c_S_of(const Simulation& simulation) {
  return waves_of(simulation).shear;
}
double c_R_of(const Simulation& simulation) {
  return waves_of(simulation).rayleigh;
}

template <auto value_of>
int push_number(lua_State* L) {
  lua_pushnumber(L, value_of(simulation_of(L)));
  return 1;
}

int push_time(lua_State* L) {
  lua_pushnumber(L, simulation_of(L).time());
  return 1;
}

int push_steps(lua_State* L) {
  lua_pushinteger(L, simulation_of(L).state().step);
  return 1;
}

int push_dt(lua_State* L) {
  lua_pushnumber(L, simulation_of(L).dt());
  return 1;
}

int push_dt_limit(lua_State* L) {
  lua_pushnumber(L, simulation_of(L).lattice().step_limit);
  return 1;
}

int push_nodes(lua_State* L) {
  lua_pushinteger(L, static_cast<lua_Integer>(simulation_of(L).lattice().grid.nodes()));
  return 1;
}

int push_bonds(lua_State* L) {
  lua_pushinteger(L, simulation_of(L).lattice().initial_bonds());
  return 1;
}

int push_hash(lua_State* L) {
  push_text(L, results_of(L).state().hash());
  return 1;
}

constexpr auto energy_keys = std::to_array<std::string_view>(
    {"kinetic", "strain", "broken", "damped", "released", "contact", "external", "residual"});
constexpr auto damage_keys = std::to_array<std::string_view>({"broken_bonds", "most"});

int push_energy(lua_State* L) {
  const Energy ledger = energy(results_of(L));
  lua_createtable(L, 0, energy_keys.size());
  close_names(L, "s.energy", energy_keys);
  set_number(L, "kinetic", ledger.kinetic);
  set_number(L, "strain", ledger.strain);
  set_number(L, "broken", ledger.broken);
  set_number(L, "damped", ledger.damped);
  set_number(L, "released", ledger.released);
  set_number(L, "contact", ledger.contact);
  set_number(L, "external", ledger.external);
  set_number(L, "residual", ledger.residual());
  return 1;
}

int push_damage(lua_State* L) {
  const DamageCount count = count_damage(results_of(L));
  lua_createtable(L, 0, damage_keys.size());
  close_names(L, "s.damage", damage_keys);
  set_integer(L, "broken_bonds", count.broken_bonds);
  set_number(L, "most", count.max);
  return 1;
}

constexpr std::array simulation_fields{
    Property{"time", "s", "Simulated time so far.", push_time},
    Property{"steps", "", "Steps taken so far.", push_steps},
    Property{"dt", "s", "The time step.", push_dt},
    Property{"dt_limit", "s", "Largest stable time step.", push_dt_limit},
    Property{"spacing", "m", "Distance between neighbouring nodes.", push_number<spacing_of>},
    Property{"horizon", "m", "Horizon of the bonds.", push_number<horizon_of>},
    Property{"m", "", "The horizon in spacings.", push_number<m_of>},
    Property{"E", "Pa", "Young's modulus of the lattice along its axes.", push_number<E_of>},
    Property{"nu", "", "Poisson's ratio of the lattice along its axes.", push_number<nu_of>},
    Property{"G0", "J/m2", "Fracture energy of the lattice along its axes.", push_number<G0_of>},
    Property{"s0", "", "Critical stretch of a bond.", push_number<s0_of>},
    Property{"c_L", "m/s", "Speed of longitudinal waves.", push_number<c_L_of>},
    Property{"c_S", "m/s", "Speed of shear waves.", push_number<c_S_of>},
    Property{"c_R", "m/s", "Speed of Rayleigh waves, the limit of a crack's speed.",
             push_number<c_R_of>},
    Property{"nodes", "", "Number of nodes of the lattice.", push_nodes},
    Property{"bonds", "", "Number of initial bonds of the plate.", push_bonds},
    Property{"energy", "J/m",
             "Table: kinetic, strain, broken, damped, released, contact, external and residual.",
             push_energy, energy_keys},
    Property{"damage", "", "Table: broken_bonds since the start, and the largest damage of a node.",
             push_damage, damage_keys},
    Property{"reactions", "N/m",
             "List of impactors, rollers, platens, supports and foundations, as s:reaction returns "
             "one.",
             push_reactions},
    Property{"hash", "", "Hash of the state; equal only if every bit is.", push_hash},
};

// Collects the methods from all files that bind some.
std::vector<Function> all_methods_of_simulation() {
  std::vector<Function> all;
  for (const std::span<const Function> part :
       {std::span<const Function>(own_methods_of_simulation), load_methods_of_simulation(),
        relax_methods(), measure_methods(), steering_methods(), checkpoint_methods(),
        background_methods(), show_methods(), reaction_methods(), series_methods(), chart_methods(),
        gauge_methods(), values_methods(), fracture_methods(), graph_methods()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

const TypeDoc& simulation_type() {
  static const std::vector<Function> all = all_methods_of_simulation();
  static const TypeDoc type{.name = "simulation",
                            .sentence = "A plate being solved, and its output.",
                            .methods = all,
                            .fields = simulation_fields,
                            .to_text = guarded<simulation_to_text>,
                            .destroy = destroy_object<ScriptedRun>};
  return type;
}

std::span<const Function> simulation_functions() {
  static constexpr std::array functions{
      Function{&simulate_doc, guarded<simulate>, Replayed::declares}};
  return functions;
}

}  // namespace hackle
