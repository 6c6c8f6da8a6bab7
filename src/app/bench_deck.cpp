// SPDX-License-Identifier: MIT
#include "app/bench_deck.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/stopwatch.hpp"

namespace hackle {
BenchDeck bench_deck(const Configuration& configuration, int nodes) {
  constexpr double width = 0.1, height = 0.04, stress = 12e6;
  BenchDeck deck;
  deck.numerics.spacing = std::sqrt(width * height / nodes);
  deck.numerics.precision = configuration.precision;
  deck.numerics.fused = configuration.fused;
  deck.numerics.fidelity = configuration.fidelity;
  Plate& plate = deck.plate;
  plate.width = width;
  plate.height = height;
  plate.material = {"Duran 50 glass", 65e9, 2235.0, 0.2, 204.0};
  plate.material.alpha = configuration.alpha;
  plate.cracks.push_back({{0.0, 0.5 * height}, {0.5 * width, 0.5 * height}});
  plate.loads.tractions.push_back({Edge::top, {0.0, stress}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -stress}});
  for (const Edge edge : {Edge::top, Edge::bottom})
    plate.no_fail.push_back(strip(plate, edge, deck.numerics.horizon_or_default()));
  return deck;
}

bool is_possible(const Configuration& configuration, InstructionSet set) {
  return !configuration.fused || can_fuse(set);
}

double measure_speed(Simulation& simulation, int steps) {
  double seconds = 0.0;
  {
    const Stopwatch watch(seconds);
    for (int step = 0; step < steps && !interrupted(); ++step) simulation.step();
  }
  if (interrupted()) throw Error(ErrorKind::interrupted, "interrupted, nothing was measured");
  simulation.check_finite();
  return static_cast<double>(simulation.lattice().grid.nodes()) * steps / seconds;
}

}  // namespace hackle
