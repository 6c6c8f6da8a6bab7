// SPDX-License-Identifier: MIT
// The summary of one simulation for `hackle run --json`. The meaning of every key is fixed by
// `schema`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "lattice/elastic_response.hpp"
#include "measure/crack_graph.hpp"
#include "measure/energy.hpp"
#include "measure/fragment_list.hpp"
#include "output/report/error_budget.hpp"
#include "output/report/features.hpp"
#include "output/report/field_sample.hpp"
#include "output/report/plate_sample.hpp"
#include "solver/cpu/tiles.hpp"

namespace hackle {

// Wall time of each stage, seconds. Painting and encoding run beside the solver, so the parts may
// add up to more than the total.
struct StageSeconds {
  double setup = 0.0;   // building the lattice and the kernel's tables
  double solve = 0.0;   // time steps
  double render = 0.0;  // painting pictures
  double encode = 0.0;  // encoding movies
  double store = 0.0;   // writing run files and PNGs
  double total = 0.0;   // from the start of the setup until now
};

struct Summary {
  std::string script;
  std::int64_t nodes = 0;
  std::int64_t bonds = 0;  // initial bonds, each counted once
  std::int64_t steps = 0;
  double time = 0.0;      // simulated, s
  double dt = 0.0;        // s
  double dt_limit = 0.0;  // s, 2/omega_max
  Numerics numerics;      // as given
  Material material;      // of the plate itself
  std::string precision;  // "f64" or "f32"
  int threads = 0;
  PathCounts paths{};                 // tile-steps by path
  std::vector<Stage> stages;          // of a step, with shares of the solving time
  std::vector<std::string> features;  // of the kernel
  StageSeconds wall;
  Energy energy;  // J/m
  DamageCount damage;
  std::vector<Reaction> reactions;   // of bodies, supports and foundations
  std::vector<std::string> account;  // what happened, in sentences; see account.hpp
  std::optional<CrackGrowth::FirstBreak> first_break;
  CrackGraph graph;                          // the cracks, and what happened to them
  std::optional<ErrorBudget> budget;         // what it chose, if the script has one
  std::optional<SampledField> sample;        // if it was asked for, and the run came so far
  std::optional<SampledPlate> plate;         // likewise
  std::optional<FragmentList> fragments;     // likewise
  std::optional<ElasticResponse> elastic;    // likewise
  std::uint64_t peak_rss = 0;                // bytes, of the process
  std::string hash;                          // of the state
  std::vector<std::filesystem::path> files;  // complete files written
  std::vector<std::string> notes;            // on the scene and the run, printed or suppressed
  // JSON of a simulation that an earlier life of a continued script has finished: stands for all of
  // the above except the files.
  std::string told;

  // Returns nodes times steps over the solving time; 0 before the first step.
  double node_steps_per_second() const {
    return wall.solve > 0.0 ? static_cast<double>(nodes * steps) / wall.solve : 0.0;
  }
};

// What the simulation itself tells; the rest is empty.
Summary summary_of(const Simulation& simulation);

// How much the object of a summary tells: the paths of the cracks are long.
enum class SummaryDetail { usual, paths };

// Returns the object documented in README.md, "--json".
nlohmann::ordered_json to_json(const Summary& summary, SummaryDetail detail = SummaryDetail::usual);

}  // namespace hackle
