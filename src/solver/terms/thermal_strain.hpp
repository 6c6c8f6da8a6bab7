// SPDX-License-Identifier: MIT
// The thermal strain of every node in time: the sum of all temperature changes of a plate.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "lattice/load_map.hpp"
#include "solver/meetings.hpp"
#include "solver/state.hpp"
#include "solver/tabulated_amplitude.hpp"

namespace hackle {

// A bond between i and j is at rest when its e is th_i + th_j, th = alphaT dT of its ends: its
// stretch is then their mean, to the first order. More than this is beyond that order.
inline constexpr double max_thermal_strain = 0.1;

class ThermalStrain {
 public:
  // Throws what spread_heat throws.
  ThermalStrain(const Plate& plate, const Lattice& lattice, double dt);

  // Nothing is heated.
  bool empty() const { return parts_.empty(); }

  // Functions of time are asked now for all steps begin <= n < end. Throws what they throw.
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end);

  // Finds the strain at the time of the state. True when it is not what it was. Throws Error
  // (refused), and leaves it as it was, where it would exceed max_thermal_strain.
  bool update(const Lattice& lattice, const State& state);

  // By Grid::index; empty when nothing is heated.
  const std::vector<double>& values() const { return values_; }

  // The strain half a step before the state and half a step after it: the mean of two steps; before
  // the start it is that of the start. Work is counted from middle to middle of steps, which makes
  // it right to second order (src/solver/README.md 3.6).
  std::vector<double> before(const Lattice& lattice, const State& state) const;
  std::vector<double> after(const Lattice& lattice, const State& state) const;
  // Whether the strain changes from half a step before the state to half a step after.
  bool changes_around(const State& state) const;
  // The same, from half a step before the state to the state.
  bool changes_until(const State& state) const;
  std::size_t bytes() const;

 private:
  struct Part {
    NodeRange range;
    std::vector<double> strain;
    TabulatedAmplitude amplitude;
  };
  using Factors = std::vector<double>;                               // by part
  Factors factors_at(const State& state, std::int64_t steps) const;  // from there
  // Half a step from the state, towards a step beside it.
  Factors factors_towards(const State& state, std::int64_t steps) const;
  Factors factors_before(const State& state) const;
  std::vector<double> sum(const Lattice& lattice, const Factors& factors) const;

  double dt_;
  std::vector<Part> parts_;
  std::vector<Meeting> crowds_;  // nodes, by Grid::index, with three parts or more
  Factors factors_;              // of values_; empty before the first update
  std::vector<double> values_;
};

}  // namespace hackle
