// SPDX-License-Identifier: MIT
#include "app/bench_ranks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/bench_deck.hpp"
#include "base/machine.hpp"
#include "base/ranks/launcher.hpp"
#include "base/stopwatch.hpp"
#include "base/streams.hpp"
#include "base/units.hpp"
#include "solver/rank_cost.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

constexpr int rank_steps = 300, exchanges = 200;
constexpr double rows_of_growth = 64.0;  // of each rank, on plates that grow with the ranks
constexpr Configuration configuration{.name = "f32", .precision = Precision::f32};

// Networks of clusters by their makers' figures: a message between two nodes, and a lane of it.
constexpr std::array networks{Network{"InfiniBand HDR", 2e-6, 20e9, 3e-6},
                              Network{"10 Gb Ethernet", 30e-6, 1.1e9, 40e-6}};

double median_of(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

double seconds_of(const std::function<void()>& work) {
  double seconds = 0.0;
  {
    const Stopwatch watch(seconds);
    work();
  }
  return seconds;
}

// Values of all ranks, in their order.
std::vector<double> of_all(Ranks& ranks, double own) {
  return ranks.gather(bytes_to_send(std::vector<double>{own})).as<double>();
}

// One exchange with both neighbours, s.
double exchange_seconds(Ranks& ranks, std::size_t bytes) {
  std::vector<std::vector<std::byte>> taken(2, std::vector<std::byte>(bytes));
  const std::vector<std::byte> given(bytes);
  std::vector<Outgoing> sent;
  std::vector<Incoming> received;
  std::size_t side = 0;
  for (const int other : {ranks.rank() - 1, ranks.rank() + 1}) {
    if (other < 0 || other >= ranks.count()) continue;
    sent.push_back({other, given});
    received.push_back({other, taken[side++]});
  }
  return seconds_of([&] {
           for (int k = 0; k < exchanges; ++k) {
             ranks.begin_exchange(sent, received);
             ranks.end_exchange();
           }
         }) /
         exchanges;
}

Network network_of(Ranks& ranks) {
  constexpr std::size_t small = 64, large = 1 << 20;
  const auto slowest = [&](double own) { return std::ranges::max(of_all(ranks, own)); };
  Network network{"these ranks"};
  network.latency = slowest(exchange_seconds(ranks, small));
  const double more = slowest(exchange_seconds(ranks, large)) - network.latency;
  network.bandwidth = 2.0 * (large - small) / std::max(more, 1e-9);
  const double call = seconds_of([&] {
                        for (int k = 0; k < exchanges; ++k) ranks.any(0);
                      }) /
                      exchanges;
  network.agreement = slowest(call) / std::max(std::log2(ranks.count()), 1.0);
  return network;
}

double seconds_of_step(const BenchDeck& deck, const Execution& execution) {
  Simulation simulation(deck.plate, deck.numerics, execution);
  const double duration = rank_steps * simulation.dt();
  return seconds_of([&] { simulation.run(duration); }) /
         static_cast<double>(simulation.state().step);
}

struct Measured {
  double together = 0.0;  // s per step, median, on all ranks
  double alone = 0.0;     // of the whole plate on one rank while the others wait
  double imbalance = 0.0;
  double messages = 0.0, bytes = 0.0;  // of a rank in a step
  SharedPlate plate;
  Network network;
};

Measured measure_together(const RankBenchRequest& request, Ranks& ranks) {
  const BenchDeck deck = bench_deck(configuration, request.nodes);
  Execution execution = request.execution;
  if (execution.threads == 0) execution.threads = share_of_cores(this_launcher());
  Execution shared = execution;
  shared.ranks = &ranks;
  std::vector<double> together, alone;
  Measured measured;
  for (int round = 0; round < request.rounds; ++round) {
    const Traffic before = ranks.traffic();
    together.push_back(seconds_of_step(deck, shared));
    const Traffic after = ranks.traffic();
    measured.messages = static_cast<double>(after.messages - before.messages) / rank_steps;
    measured.bytes = static_cast<double>(after.bytes - before.bytes) / rank_steps;
    if (ranks.leads()) alone.push_back(seconds_of_step(deck, execution));
    ranks.any(0);  // the others wait
  }
  measured.together = median_of(together);
  measured.alone = of_all(ranks, alone.empty() ? 0.0 : median_of(alone)).front();
  const Lattice lattice(deck.plate, deck.numerics);
  measured.plate = {.columns = static_cast<double>(lattice.grid.nx),
                    .rows = static_cast<double>(lattice.grid.ny),
                    .reach = static_cast<double>(lattice.family.reach()),
                    .node_bytes = 2.0 * sizeof(float),
                    .node_seconds = measured.alone / static_cast<double>(lattice.grid.nodes())};
  measured.network = network_of(ranks);
  return measured;
}

Json cost_json(const StepCost& cost) {
  return {{"kernel_s", cost.kernel}, {"halo_s", cost.halo}, {"agreement_s", cost.agreement}};
}

// What the model expects of clusters whose ranks are as fast as one here.
Json expectations(const SharedPlate& here) {
  Json list = Json::array();
  for (const Network& network : networks)
    for (const double nodes : {1e8, 1e9})
      for (const int ranks : {16, 64, 256, 1024, 4096}) {
        SharedPlate plate = here;
        plate.columns = 0.25 * std::sqrt(nodes);
        plate.rows = 4.0 * std::sqrt(nodes);  // square plates have too few for 4096 ranks
        SharedPlate of_one = plate;
        of_one.rows = rows_of_growth;
        list.push_back({{"network", network.name},
                        {"nodes", nodes},
                        {"ranks", ranks},
                        {"step_s", cost_of_step(plate, ranks, network).total()},
                        {"strong", strong_efficiency(plate, ranks, network)},
                        {"weak", weak_efficiency(of_one, ranks, network)}});
      }
  return list;
}

// Ranks that share a core take turns.
SharedPlate on_shared_cores(SharedPlate plate, int threads) {
  const double wanted = this_launcher().local_count * std::max(threads, 1);
  plate.node_seconds *= std::max(wanted / static_cast<double>(sysconf(_SC_NPROCESSORS_ONLN)), 1.0);
  return plate;
}

Json ranks_json(const Measured& measured, const RankBenchRequest& request, int ranks) {
  const StepCost cost = cost_of_step(on_shared_cores(measured.plate, request.execution.threads),
                                     ranks, measured.network);
  return {{"schema", 1},
          {"kind", "ranks"},
          {"processor", processor_name()},
          {"ranks", ranks},
          {"rounds", request.rounds},
          {"nodes", measured.plate.columns * measured.plate.rows},
          {"step_s", measured.together},
          {"step_alone_s", measured.alone},
          {"speedup", measured.alone / measured.together},
          {"messages_per_step", measured.messages},
          {"bytes_per_step", measured.bytes},
          {"latency_s", measured.network.latency},
          {"bandwidth_B_s", measured.network.bandwidth},
          {"agreement_s", measured.network.agreement},
          {"model", cost_json(cost)},
          {"model_step_s", cost.total()},
          {"expected", expectations(measured.plate)}};
}

std::string micro(const Json& seconds) {
  return fmt::format("{:.1f}", 1e6 * seconds.get<double>());
}

void print_ranks(const Json& json) {
  print_out("{}, {} ranks, {} nodes, f32, medians of {} rounds\n\n",
            json["processor"].get<std::string>(), json["ranks"].get<int>(),
            grouped(static_cast<std::int64_t>(json["nodes"].get<double>())),
            json["rounds"].get<int>());
  print_out("a step alone      {:>10} us\n", micro(json["step_alone_s"]));
  print_out("a step together   {:>10} us   {:.2f} times as fast\n", micro(json["step_s"]),
            json["speedup"].get<double>());
  const Json& model = json["model"];
  print_out("the model expects {:>10} us   kernel {}, halo {}, agreement {}\n",
            micro(json["model_step_s"]), micro(model["kernel_s"]), micro(model["halo_s"]),
            micro(model["agreement_s"]));
  print_out(
      "between ranks     {:>10} us latency, {:.1f} GB/s, {} us per collective call and "
      "doubling\n",
      micro(json["latency_s"]), 1e-9 * json["bandwidth_B_s"].get<double>(),
      micro(json["agreement_s"]));
  print_out("each sends        {:>10.1f} messages and {:.1f} kB in a step\n\n",
            json["messages_per_step"].get<double>(), 1e-3 * json["bytes_per_step"].get<double>());
  print_out("{:<16} {:>8} {:>6} {:>12} {:>8} {:>8}\n", "expected on", "nodes", "ranks", "ms a step",
            "strong", "weak");
  for (const Json& row : json["expected"])
    print_out("{:<16} {:>8.0e} {:>6} {:>12.3f} {:>8.2f} {:>8.2f}\n",
              row["network"].get<std::string>(), row["nodes"].get<double>(),
              row["ranks"].get<int>(), 1e3 * row["step_s"].get<double>(),
              row["strong"].get<double>(), row["weak"].get<double>());
}

}  // namespace

int bench_ranks(const RankBenchRequest& request, Ranks& ranks) {
  const Json json = ranks_json(measure_together(request, ranks), request, ranks.count());
  if (request.json)
    print_out("{}\n", json.dump());
  else
    print_ranks(json);
  return 0;
}

}  // namespace hackle
