// SPDX-License-Identifier: MIT
#include "app/command_bench.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bench_deck.hpp"
#include "app/bench_ranks.hpp"
#include "app/company.hpp"
#include "app/exit_code.hpp"
#include "app/lammps_peer.hpp"
#include "app/voice.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "base/ranks/mpi_module.hpp"
#include "base/streams.hpp"
#include "base/units.hpp"
#include "base/version.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

// 32 us of the default plate: the crack starts and branches.
constexpr int our_steps = 300;
// LAMMPS visits every bond in every step, whatever happens on the plate: fewer steps suffice.
constexpr int lammps_steps = 50;

// The measurements of one row, one value per round.
struct Row {
  Configuration configuration;
  int nodes = 0, bonds = 0, threads = 1;
  double bytes_per_node = 0.0;
  std::vector<double> speeds;  // node-steps/s
  std::vector<double> ratios;  // relative to LAMMPS in the same round; empty without LAMMPS
};

struct LammpsRow {
  LammpsRun last;
  std::vector<double> speeds;
};

struct Measurements {
  std::vector<Row> rows;
  std::map<double, LammpsRow> lammps;  // by alpha
};

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

bool with_lammps(const BenchRequest& request) {
  if (request.peer == "none") return false;
  const bool installed = lammps_is_installed();
  if (request.peer == "lammps" && !installed)
    throw Error(ErrorKind::usage, "bench: --peer lammps needs the program lmp on the PATH",
                "apt-get install lammps");
  return installed;
}

Measurements nothing_measured(bool lammps, InstructionSet set) {
  Measurements measurements;
  for (const Configuration& configuration : configurations) {
    if (!is_possible(configuration, set)) continue;
    measurements.rows.push_back({configuration});
    if (lammps) measurements.lammps[configuration.alpha];
  }
  return measurements;
}

void measure(Row& row, const BenchRequest& request) {
  const BenchDeck deck = bench_deck(row.configuration, request.nodes);
  Execution execution = request.execution;
  if (!row.configuration.threads) execution.threads = 1;
  Simulation simulation(deck.plate, deck.numerics, execution);
  row.speeds.push_back(measure_speed(simulation, our_steps));
  row.nodes = static_cast<int>(simulation.lattice().grid.nodes());
  row.bonds = simulation.lattice().family.bonds();
  row.threads = simulation.threads();
  row.bytes_per_node = static_cast<double>(simulation.bytes()) / row.nodes;
}

void measure(LammpsRow& row, double alpha, const BenchRequest& request) {
  const BenchDeck deck = bench_deck(configurations.front(), request.nodes);
  row.last = run_lammps(deck, alpha, lammps_steps);
  row.speeds.push_back(row.last.node_steps_per_second());
}

// Calls done(name) after each measurement.
template <class Done>
void measure_round(Measurements& measurements, const BenchRequest& request, const Done& done) {
  for (auto& [alpha, row] : measurements.lammps) {
    measure(row, alpha, request);
    done(fmt::format("LAMMPS, alpha {}", alpha));
  }
  for (Row& row : measurements.rows) {
    measure(row, request);
    const auto peer = measurements.lammps.find(row.configuration.alpha);
    if (peer != measurements.lammps.end())
      row.ratios.push_back(row.speeds.back() / peer->second.speeds.back());
    done(std::string(row.configuration.name));
  }
}

Measurements measure_all(const BenchRequest& request) {
  Measurements measurements =
      nothing_measured(with_lammps(request), request.execution.instruction_set);
  Progress progress(talk(request.quiet));
  const double parts =
      request.rounds * static_cast<double>(measurements.rows.size() + measurements.lammps.size());
  double part = 0.0;
  progress.due(part);  // starts its clock
  for (int round = 1; round <= request.rounds; ++round)
    measure_round(measurements, request, [&](const std::string& name) {
      const double fraction = ++part / parts;
      if (progress.due(fraction))
        progress.show(fraction, fmt::format("round {} of {}, {}", round, request.rounds, name));
    });
  return measurements;
}

Json to_json(const Row& row) {
  const double speed = median(row.speeds);
  Json json{{"name", row.configuration.name},
            {"nodes", row.nodes},
            {"steps", our_steps},
            {"node_steps_per_second", speed},
            {"bond_visits_per_second", speed * row.bonds},
            {"bytes_per_node", row.bytes_per_node},
            {"threads", row.threads}};
  json["ratio_to_lammps"] = row.ratios.empty() ? Json() : Json(median(row.ratios));
  return json;
}

Json to_json(const LammpsRow& row, double alpha, int bonds) {
  const double speed = median(row.speeds);
  return {{"alpha", alpha},
          {"nodes", row.last.nodes},
          {"steps", row.last.steps},
          {"node_steps_per_second", speed},
          {"bond_visits_per_second", speed * bonds},
          {"bytes_per_node", row.last.bytes_per_node()},
          {"threads", 1}};
}

Json machine(InstructionSet set) {
  return {{"processor", processor_name()},
          {"cores", available_cores()},
          {"instruction_set", instruction_set_names[static_cast<std::size_t>(set)]},
          {"compiler", compiler()},
          {"version", version()},
          {"git", git_hash()}};
}

// "lammps" is null if it was not requested or is not installed.
Json to_json(const Measurements& measurements, const BenchRequest& request) {
  Json json{{"schema", 1},
            {"machine", machine(request.execution.instruction_set)},
            {"rounds", request.rounds}};
  json["rows"] = Json::array();
  for (const Row& row : measurements.rows) json["rows"].push_back(to_json(row));
  json["lammps"] = nullptr;
  if (measurements.lammps.empty()) return json;
  json["lammps"]["version"] = measurements.lammps.begin()->second.last.version;
  for (const auto& [alpha, row] : measurements.lammps)
    json["lammps"]["rows"].push_back(to_json(row, alpha, measurements.rows.front().bonds));
  return json;
}

void print_row(const std::string& name, const Json& row) {
  const Json ratio = row.value("ratio_to_lammps", Json());
  print_out("{:<20} {:>7} {:>6} {:>14.2f} {:>15.3f} {:>11.0f} {:>10}\n", name,
            row["threads"].get<int>(), row["steps"].get<int>(),
            1e-6 * row["node_steps_per_second"].get<double>(),
            1e-9 * row["bond_visits_per_second"].get<double>(), row["bytes_per_node"].get<double>(),
            ratio.is_null() ? "" : fmt::format("{:.1f}", ratio.get<double>()));
}

void print_table(const Json& json) {
  const Json& about = json["machine"];
  print_out("{}, {}\n", about["processor"].get<std::string>(),
            about["instruction_set"].get<std::string>());
  print_out("{} nodes, medians of {} rounds\n\n", grouped(json["rows"][0]["nodes"].get<int>()),
            json["rounds"].get<int>());
  print_out("{:<20} {:>7} {:>6} {:>14} {:>15} {:>11} {:>10}\n", "", "threads", "steps",
            "M node-steps/s", "G bond visits/s", "bytes/node", "to LAMMPS");
  for (const Json& row : json["rows"]) print_row(row["name"].get<std::string>(), row);
  if (json["lammps"].is_null()) return;
  for (const Json& row : json["lammps"]["rows"])
    print_row(fmt::format("LAMMPS, alpha {}", row["alpha"].get<double>()), row);
  print_out("\nLAMMPS {}, peri/pmb\n", json["lammps"]["version"].get<std::string>());
}

}  // namespace

namespace {

int measure_ranks(const BenchRequest& request) {
  Ranks* ranks = find_ranks(120.0);
  if (ranks == nullptr)
    throw Error(ErrorKind::usage, "bench: --ranks needs several of them",
                "start it as mpirun -n 2 hackle bench --ranks");
  const Company company(ranks);
  return company.leave(exit_code_of([&] {
    return bench_ranks({request.rounds, request.nodes, request.execution, request.json}, *ranks);
  }));
}

}  // namespace

int command_bench(const BenchRequest& request) {
  const InterruptHandler handler;
  return exit_code_of([&] {
    if (request.ranks) return measure_ranks(request);
    const Json json = to_json(measure_all(request), request);
    if (request.json)
      print_out("{}\n", json.dump());
    else
      print_table(json);
    return 0;
  });
}

}  // namespace hackle
