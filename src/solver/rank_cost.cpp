// SPDX-License-Identifier: MIT
#include "solver/rank_cost.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {

namespace {

// A task begins `reach` rows early and computes there the bonds that end in its own rows, about
// half of them. A slab is swept in three tasks: its rows at both ends, and those between.
double rows_of_slab(const SharedPlate& plate, int ranks) {
  return plate.rows / ranks + (ranks > 1 ? 3.0 * 0.5 * plate.reach : 0.0);
}

}  // namespace

double halo_bytes(const SharedPlate& plate) {
  return 2.0 * plate.reach * plate.columns * plate.node_bytes;
}

StepCost cost_of_step(const SharedPlate& plate, int ranks, const Network& network) {
  StepCost cost;
  const double row = plate.columns * plate.node_seconds;
  cost.kernel = row * rows_of_slab(plate, ranks) * (1.0 + plate.imbalance);
  if (ranks == 1) return cost;
  const double hidden = row * std::max(plate.rows / ranks - 4.0 * plate.reach, 0.0);
  const double sent = network.latency + halo_bytes(plate) / network.bandwidth;
  // The ranges of tiles follow in a second exchange, which nothing hides.
  cost.halo = std::max(sent - hidden, 0.0) + network.latency;
  cost.agreement = collectives_of_step * network.agreement * std::log2(ranks);
  return cost;
}

double strong_efficiency(const SharedPlate& plate, int ranks, const Network& network) {
  return cost_of_step(plate, 1, network).total() /
         (ranks * cost_of_step(plate, ranks, network).total());
}

double weak_efficiency(const SharedPlate& of_one, int ranks, const Network& network) {
  SharedPlate all = of_one;
  all.rows *= ranks;
  return cost_of_step(of_one, 1, network).total() / cost_of_step(all, ranks, network).total();
}

}  // namespace hackle
