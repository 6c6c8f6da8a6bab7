// SPDX-License-Identifier: MIT
#include "study/moments.hpp"

#include "study/quantity.hpp"

namespace hackle {

double moment_of_comparison(const Outcome& outcome) {
  constexpr double before_the_first = 0.8, middle = 0.5;
  const auto first = value_of(outcome, *quantity_named("first_bond.time")).number;
  return first ? before_the_first * *first : middle * outcome.told["time_s"].get<double>();
}

}  // namespace hackle
