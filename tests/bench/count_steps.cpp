// SPDX-License-Identifier: MIT
// Solves some steps of a plate in one thread, with AVX2 where there is: for counting instructions
// from outside.
//
//   count_steps STEPS NODES [f32|f64] [zones] [alpha] [fidelity] [fused] [mixed] [heated] [warming]
#include <cstdlib>
#include <set>
#include <string>

#include "app/bench_deck.hpp"

int main(int argc, char** argv) {
  using namespace hackle;
  if (argc < 3) return 2;
  const std::set<std::string> words(argv + 3, argv + argc);
  const auto with = [&](const char* word) { return words.contains(word); };
  Configuration configuration;
  configuration.precision = with("f32") ? Precision::f32 : Precision::f64;
  configuration.alpha = with("alpha") ? 0.25 : 0.0;
  configuration.fidelity = with("fidelity") ? 1.0 : 0.0;
  configuration.fused = with("fused");
  BenchDeck deck = bench_deck(configuration, std::atoi(argv[2]));
  // Elastic and all in motion: what is counted is the same in every step.
  if (!with("zones")) deck.plate.no_fail.clear();
  for (Traction& traction : deck.plate.loads.tractions)
    traction.stress = Vec2(1e-3 * traction.stress.constant());
  Plate& plate = deck.plate;
  if (with("mixed")) {
    Material other = plate.material;
    other.rho *= 1.5;
    plate.inclusions.push_back(
        {rectangle({0.0, 0.0}, {0.5 * plate.width, 0.5 * plate.height}), other});
  }
  if (with("heated") || with("warming")) {
    plate.material.alphaT = 1e-6;
    plate.loads.thermal_loads.push_back(
        {std::nullopt, 1.0, with("warming") ? ramp(1e-3) : Amplitude()});
  }
  const InstructionSet set =
      is_supported(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::baseline;
  Simulation simulation(deck.plate, deck.numerics, {1, set});
  State state = simulation.state();
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i) state.set_v(i, j, {1e-9 * i, 1e-9 * j});
  simulation.restore(state);
  for (int step = 0; step < std::atoi(argv[1]); ++step) simulation.step();
  return 0;
}
