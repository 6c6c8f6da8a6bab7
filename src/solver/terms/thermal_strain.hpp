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
#include "solver/tabulated_course.hpp"

namespace hackle {

// A bond between i and j is unstressed if its e is th_i + th_j, th = alphaT dT of its ends: its
// stretch is then their mean, to first order. Larger strains exceed the range of that order.
inline constexpr double max_thermal_strain = 0.1;

class ThermalStrain {
 public:
  // Throws what spread_heat throws.
  ThermalStrain(const Plate& plate, const Lattice& lattice, double dt);

  // Returns true if nothing is heated.
  bool empty() const { return parts_.empty(); }

  // Evaluates functions of time for all steps begin <= n < end. Throws what they throw.
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end);

  // Computes the strain at the time of the state. Returns whether it has changed. Throws Error
  // (refused), and leaves it unchanged, if it would exceed max_thermal_strain.
  bool update(const Lattice& lattice, const State& state);

  // By Grid::index; empty if nothing is heated.
  const std::vector<double>& values() const { return values_; }

  // Return the strain half a step before the state and half a step after it: the mean of two steps;
  // before the start it is that of the start. Work is counted from middle to middle of steps, which
  // makes it exact to second order (src/solver/README.md 3.6).
  std::vector<double> before(const Lattice& lattice, const State& state) const;
  std::vector<double> after(const Lattice& lattice, const State& state) const;
  // Returns whether the strain changes from half a step before the state to half a step after.
  bool changes_around(const State& state) const;
  // Returns the same from half a step before the state to the state.
  bool changes_until(const State& state) const;
  std::size_t bytes() const;

 private:
  struct Part {
    NodeRange range;
    std::vector<double> strain;
    TabulatedAmplitude amplitude;
    mutable TabulatedCourse<double> course;  // keeps what it was asked for
    std::vector<std::size_t> at;             // of the nodes of the course, in `strain`
  };
  // The strain of a part: a factor times its own strain, or times `course` if that is not empty.
  struct Scaled {
    double factor;
    std::vector<double> course;
  };
  using Factors = std::vector<double>;                               // by part
  Factors factors_at(const State& state, std::int64_t steps) const;  // from there
  // Returns the factors half a step from the state, towards a neighbouring step.
  Factors factors_towards(const State& state, std::int64_t steps) const;
  Factors factors_before(const State& state) const;
  // Returns the strain of every part at the state, or the mean of that and the one `steps` later.
  std::vector<Scaled> scaled(const State& state, std::int64_t steps) const;
  std::vector<double> course_of(const Part& part, const State& state, std::int64_t steps) const;
  std::vector<double> sum(const Lattice& lattice, const std::vector<Scaled>& scaled) const;

  double dt_;
  bool has_courses_ = false;
  std::vector<Part> parts_;
  std::vector<Meeting> crowds_;  // nodes, by Grid::index, with three or more parts
  Factors factors_;              // of values_; empty before the first update
  std::vector<double> values_;
};

}  // namespace hackle
