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

void ThermalStrain::tabulate(std::int64_t begin, std::int64_t end) {
  for (Part& part : parts_) part.amplitude.tabulate(begin, end, dt_);
}

ThermalStrain::Factors ThermalStrain::factors_at(std::int64_t step) const {
  Factors factors;
  factors.reserve(parts_.size());
  for (const Part& part : parts_) factors.push_back(part.amplitude.at(step, dt_));
  return factors;
}

ThermalStrain::Factors ThermalStrain::factors_before(std::int64_t step) const {
  Factors factors = factors_at(step);
  if (step == 0) return factors;
  const Factors earlier = factors_at(step - 1);
  for (std::size_t k = 0; k < factors.size(); ++k) factors[k] = 0.5 * (earlier[k] + factors[k]);
  return factors;
}

bool ThermalStrain::update(const Lattice& lattice, std::int64_t step) {
  if (parts_.empty()) return false;
  Factors factors = factors_at(step);
  if (factors == factors_) return false;
  values_ = sum(lattice, factors);
  factors_ = std::move(factors);
  return true;
}

std::vector<double> ThermalStrain::before(const Lattice& lattice, std::int64_t step) const {
  return parts_.empty() ? std::vector<double>() : sum(lattice, factors_before(step));
}

bool ThermalStrain::changes_around(std::int64_t step) const {
  return factors_before(step) != factors_before(step + 1);
}

bool ThermalStrain::changes_until(std::int64_t step) const {
  return factors_before(step) != factors_at(step);
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
