// SPDX-License-Identifier: MIT
#include "solver/thermal_strain.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {

ThermalStrain::ThermalStrain(const Plate& plate, const Lattice& lattice, double dt) : dt_(dt) {
  for (SpreadHeat& heat : spread_heat(plate, lattice))
    parts_.push_back({std::move(heat.nodes), Amplitude(heat.course, 0.0)});
}

void ThermalStrain::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end) {
  for (Part& part : parts_) part.amplitude.tabulate(clock, begin, end, dt_);
}

ThermalStrain::Factors ThermalStrain::factors_at(const State& state, std::int64_t steps) const {
  Factors factors;
  factors.reserve(parts_.size());
  for (const Part& part : parts_)
    factors.push_back(part.amplitude.at(state.clock, state.step + steps, dt_));
  return factors;
}

ThermalStrain::Factors ThermalStrain::factors_towards(const State& state,
                                                      std::int64_t steps) const {
  Factors factors = factors_at(state, 0);
  const Factors beside = factors_at(state, steps);
  for (std::size_t k = 0; k < factors.size(); ++k) factors[k] = 0.5 * (beside[k] + factors[k]);
  return factors;
}

ThermalStrain::Factors ThermalStrain::factors_before(const State& state) const {
  return state.is_start() ? factors_at(state, 0) : factors_towards(state, -1);
}

bool ThermalStrain::update(const Lattice& lattice, const State& state) {
  if (parts_.empty()) return false;
  Factors factors = factors_at(state, 0);
  if (factors == factors_) return false;
  values_ = sum(lattice, factors);
  factors_ = std::move(factors);
  return true;
}

std::vector<double> ThermalStrain::before(const Lattice& lattice, const State& state) const {
  return parts_.empty() ? std::vector<double>() : sum(lattice, factors_before(state));
}

std::vector<double> ThermalStrain::after(const Lattice& lattice, const State& state) const {
  return parts_.empty() ? std::vector<double>() : sum(lattice, factors_towards(state, 1));
}

bool ThermalStrain::changes_around(const State& state) const {
  return factors_before(state) != factors_towards(state, 1);
}

bool ThermalStrain::changes_until(const State& state) const {
  return factors_before(state) != factors_at(state, 0);
}

std::size_t ThermalStrain::bytes() const {
  std::size_t sum = values_.size() * sizeof(double);
  for (const Part& part : parts_) sum += part.nodes.size() * sizeof(HeatedNode);
  return sum;
}

std::vector<double> ThermalStrain::sum(const Lattice& lattice,
                                       const std::vector<double>& factors) const {
  std::vector<double> strain(lattice.grid.nodes());
  for (std::size_t k = 0; k < parts_.size(); ++k)
    for (const HeatedNode& node : parts_[k].nodes) {
      double& own = strain[lattice.grid.index(node.i, node.j)];
      own += factors[k] * node.strain;
      if (std::abs(own) <= most_thermal_strain) continue;
      const Vec2 place = lattice.grid.position(node.i, node.j);
      throw Error(
          ErrorKind::refused,
          fmt::format("temperature: it strains the material by {:.3g} at x = {}, y = {}: "
                      "alphaT times the change must lie within +-{:g}",
                      own, quantity(place.x(), "m"), quantity(place.y(), "m"), most_thermal_strain),
          "take a smaller change of temperature; alphaT of glass is about 3e-6 to 9e-6/K");
    }
  return strain;
}

}  // namespace hackle
