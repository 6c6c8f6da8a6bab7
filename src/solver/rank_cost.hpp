// SPDX-License-Identifier: MIT
// How long a step takes on several ranks (src/solver/README.md 10.6).
#pragma once

#include <string_view>

namespace hackle {

// What joins the ranks, as Hackle sees it.
struct Network {
  std::string_view name;
  double latency = 0.0;    // s, of an exchange of small messages between neighbours
  double bandwidth = 0.0;  // B/s, of one in large messages
  double agreement = 0.0;  // s, of a collective call, per doubling of the ranks
};

// A plate that is shared out, and how fast one rank is.
struct SharedPlate {
  double columns = 0.0;
  double rows = 0.0;
  double reach = 4.0;         // rows that a rank needs of each neighbour
  double node_bytes = 8.0;    // of displacement, two numbers
  double node_seconds = 0.0;  // of a node in a step on one rank
  double imbalance = 0.0;     // by how much the slowest rank takes longer than the mean
};

// Of one step, s.
struct StepCost {
  double kernel = 0.0;     // of the slowest rank, with the rows that two ranks compute
  double halo = 0.0;       // what of the messages is not hidden behind inner rows
  double agreement = 0.0;  // collective calls

  double total() const { return kernel + halo + agreement; }
};

// Who looks, who is interrupted, what broke, and one sum over rows, which takes two calls.
inline constexpr double collectives_of_step = 5.0;

StepCost cost_of_step(const SharedPlate& plate, int ranks, const Network& network);

// Bytes that a rank in the middle sends in a step.
double halo_bytes(const SharedPlate& plate);

// Time on one rank over that on `ranks`, per rank: 1 is ideal.
double strong_efficiency(const SharedPlate& plate, int ranks, const Network& network);
// The same for a plate whose rows grow with the ranks.
double weak_efficiency(const SharedPlate& of_one, int ranks, const Network& network);

}  // namespace hackle
