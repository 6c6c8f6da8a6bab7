// SPDX-License-Identifier: MIT
// The best of many: those that no other one beats in cost and error at once (Pareto).
#pragma once

#include <span>
#include <vector>

namespace hackle {

struct Candidate {
  double cost = 0.0;
  double error = 0.0;  // not finite: never on the front
};

// Returns whether each is on the front: every other one costs more or errs more, or is equal in
// both and comes later.
std::vector<bool> front_of(std::span<const Candidate> all);

}  // namespace hackle
