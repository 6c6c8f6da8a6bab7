// SPDX-License-Identifier: MIT
// Times steps of the benchmark's plate in every configuration and three sizes: in the caches of a
// core, in those of the processor, and in memory.
//
//   build/release/bin/bench_kernel --benchmark_filter=f64/64000
#include <string>

#include <benchmark/benchmark.h>

#include "app/bench_deck.hpp"

namespace hackle {
namespace {

void time_steps(benchmark::State& timing, const Configuration& configuration, int nodes) {
  const BenchDeck deck = bench_deck(configuration, nodes);
  Simulation simulation(deck.plate, deck.numerics, {configuration.threads ? 0 : 1});
  for (auto _ : timing) simulation.step();
  const auto node_steps = static_cast<double>(simulation.lattice().grid.nodes()) *
                          static_cast<double>(timing.iterations());
  using benchmark::Counter;
  timing.counters["node-steps/s"] = Counter(node_steps, Counter::kIsRate);
  timing.counters["visits/s"] =
      Counter(node_steps * simulation.lattice().family.bonds(), Counter::kIsRate);
  timing.counters["bytes/node"] = static_cast<double>(simulation.bytes()) /
                                  static_cast<double>(simulation.lattice().grid.nodes());
}

void register_all() {
  for (const Configuration& configuration : configurations)
    for (const int nodes : {16000, 64000, 256000})
      benchmark::RegisterBenchmark(
          (std::string(configuration.name) + "/" + std::to_string(nodes)).c_str(), time_steps,
          configuration, nodes)
          ->Unit(benchmark::kMicrosecond)
          ->UseRealTime();
}

}  // namespace
}  // namespace hackle

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  hackle::register_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
