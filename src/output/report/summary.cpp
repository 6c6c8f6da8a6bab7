// SPDX-License-Identifier: MIT
#include "output/report/summary.hpp"

#include <numeric>

#include <nlohmann/json.hpp>

#include "base/machine.hpp"
#include "output/files/graph_file.hpp"
#include "output/report/ledger_remark.hpp"
#include "store/noun_writer.hpp"

namespace hackle {
namespace {

nlohmann::ordered_json to_json(const StageSeconds& wall) {
  return {{"setup", wall.setup},   {"solve", wall.solve}, {"render", wall.render},
          {"encode", wall.encode}, {"store", wall.store}, {"total", wall.total}};
}

nlohmann::ordered_json to_json(const Energy& energy) {
  return {{"kinetic", energy.kinetic},   {"strain", energy.strain},
          {"broken", energy.broken},     {"damped", energy.damped},
          {"released", energy.released}, {"contact", energy.contact},
          {"external", energy.external}, {"residual", energy.residual()}};
}

nlohmann::ordered_json to_json(const std::vector<Stage>& stages) {
  nlohmann::ordered_json json;
  for (const Stage& stage : stages) json[std::string(stage.name)] = stage.share;
  return json;
}

nlohmann::ordered_json to_json(const std::vector<Reaction>& reactions) {
  auto json = nlohmann::ordered_json::array();
  for (const Reaction& one : reactions)
    json.push_back({{"name", one.name},
                    {"body", one.who},
                    {"number", one.number},
                    {"centre_m", {one.centre.x(), one.centre.y()}},
                    {"force_N_per_m", {one.force.x(), one.force.y()}},
                    {"moment_N", one.moment},
                    {"moved_m", {one.moved.x(), one.moved.y()}}});
  return json;
}

nlohmann::ordered_json to_json(const FragmentList& fragments) {
  auto areas = nlohmann::ordered_json::array();
  for (const MeasuredFragment& one : fragments.all) areas.push_back(one.area);
  return {{"areas_m2", areas}, {"dust_m2", fragments.dust}};
}

// Returns shares of all tile-steps.
nlohmann::ordered_json to_json(const PathCounts& paths) {
  const auto all =
      static_cast<double>(std::accumulate(paths.begin(), paths.end(), std::int64_t{0}));
  nlohmann::ordered_json json;
  for (std::size_t path = 0; path < paths.size(); ++path)
    json[std::string(path_names[path])] = all > 0.0 ? static_cast<double>(paths[path]) / all : 0.0;
  return json;
}

}  // namespace

Summary summary_of(const Simulation& simulation) {
  Summary summary;
  summary.nodes = static_cast<std::int64_t>(simulation.lattice().grid.nodes());
  summary.bonds = simulation.lattice().initial_bonds();
  summary.steps = simulation.state().step;
  summary.time = simulation.time();
  summary.dt = simulation.dt();
  summary.dt_limit = simulation.lattice().step_limit;
  summary.numerics = simulation.numerics();
  summary.material = simulation.plate().material;
  summary.precision = name_of(simulation.state().precision());
  summary.paths = simulation.path_counts();
  summary.threads = simulation.threads();
  summary.stages = stages(simulation);
  summary.features = kernel_features(simulation);
  summary.energy = energy(simulation);
  summary.damage = count_damage(simulation);
  summary.reactions = simulation.reactions();
  summary.peak_rss = peak_resident_memory();
  summary.hash = simulation.state().hash();
  summary.wall.solve = simulation.solve_seconds();
  return summary;
}

nlohmann::ordered_json to_json(const Summary& summary, SummaryDetail detail) {
  if (!summary.told.empty()) return nlohmann::ordered_json::parse(summary.told);
  nlohmann::ordered_json json;
  json["schema"] = 1;
  json["script"] = summary.script;
  json["nodes"] = summary.nodes;
  json["bonds"] = summary.bonds;
  json["steps"] = summary.steps;
  json["time_s"] = summary.time;
  json["dt_s"] = summary.dt;
  json["dt_limit_s"] = summary.dt_limit;
  json["numerics"] = NounWriter::json_of(summary.numerics);
  json["material"] = NounWriter::json_of(summary.material);
  json["precision"] = summary.precision;
  json["threads"] = summary.threads;
  json["tile_paths"] = to_json(summary.paths);
  json["step_shares"] = to_json(summary.stages);
  json["kernel_features"] = summary.features;
  json["wall_s"] = to_json(summary.wall);
  json["node_steps_per_s"] = summary.node_steps_per_second();
  json["energy_J_per_m"] = to_json(summary.energy);
  json["residual_share"] = residual_share(summary.energy);
  json["damage"] = {{"broken_bonds", summary.damage.broken_bonds}, {"max", summary.damage.max}};
  if (!summary.reactions.empty()) json["reactions"] = to_json(summary.reactions);
  json["account"] = summary.account;
  if (const auto& first = summary.first_break)
    json["first_break"] = {{"time_s", first->time},
                           {"place_m", {first->place.x(), first->place.y()}}};
  if (!summary.graph.events.empty())
    json["events"] = to_json(summary.graph.events, summary.graph.rayleigh);
  if (detail == SummaryDetail::paths) json["graph"] = to_json(summary.graph);
  if (summary.budget) json["budget"] = to_json(*summary.budget);
  if (summary.sample) json["sample"] = to_json(*summary.sample);
  if (summary.plate) json["plate"] = to_json(*summary.plate);
  if (summary.fragments) json["fragments"] = to_json(*summary.fragments);
  if (const auto& elastic = summary.elastic)
    json["elastic"] = {{"stiffness_Pa", elastic->stiffness},
                       {"wavelength_m", elastic->wavelength},
                       {"wave_speed_m_per_s", elastic->wave_speed}};
  json["peak_rss_bytes"] = summary.peak_rss;
  json["hash"] = summary.hash;
  json["files"] = nlohmann::ordered_json::array();
  for (const auto& file : summary.files) json["files"].push_back(file.string());
  json["notes"] = summary.notes;
  return json;
}

}  // namespace hackle
