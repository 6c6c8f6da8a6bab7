// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scene/amplitude.hpp"
#include "solver/clock.hpp"

namespace hackle {

// An amplitude, evaluated at the steps of a run.
class TabulatedAmplitude {
 public:
  // In a step the amplitude is that at the time when the share `shift` of the step has passed.
  TabulatedAmplitude(Amplitude amplitude, double shift)
      : amplitude_(std::move(amplitude)), shift_(shift) {}

  bool is_constant() const { return amplitude_.is_constant(); }
  // Evaluates a function for the steps begin <= n < end, so that at() need not. Throws Error
  // (refused) for more than 1e8 steps.
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt);
  double at(const Clock& clock, std::int64_t step, double dt) const;
  const Amplitude& amplitude() const { return amplitude_; }

 private:
  double evaluate(const Clock& clock, std::int64_t step, double dt) const {
    return amplitude_.at(clock.time(step, shift_, dt));
  }

  Amplitude amplitude_;
  double shift_;
  Clock clock_;             // of the table
  std::int64_t first_ = 0;  // step of table_[0]
  std::vector<double> table_;
};

}  // namespace hackle
