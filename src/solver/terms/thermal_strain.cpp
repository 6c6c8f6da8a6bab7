// SPDX-License-Identifier: MIT
#include "solver/terms/thermal_strain.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "solver/exact_sum.hpp"

namespace hackle {
namespace {

// Calls work(place in the range, node) in order.
template <class Work>
void for_places(const NodeRange& range, const Grid& grid, const Work& work) {
  std::size_t place = 0;
  for (int j = range.first_j; j <= range.last_j; ++j)
    for (int i = range.first_i; i <= range.last_i; ++i) work(place++, grid.index(i, j));
}

// Returns the nodes that lie in three or more regions, by Grid::index.
std::vector<Meeting> crowds_of(const std::vector<SpreadHeat>& heat, const Grid& grid) {
  std::vector<std::vector<std::size_t>> places;
  for (const SpreadHeat& part : heat) {
    std::vector<std::size_t>& at = places.emplace_back();
    at.reserve(part.strain.size());
    for_places(part.range, grid, [&](std::size_t, std::size_t node) { at.push_back(node); });
  }
  std::vector<const std::vector<std::size_t>*> lists;
  lists.reserve(places.size());
  for (const auto& list : places) lists.push_back(&list);
  return find_meetings(lists, grid.nodes());
}

void check(const std::vector<double>& strain, const Grid& grid) {
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double own = strain[grid.index(i, j)];
      if (std::abs(own) <= max_thermal_strain) continue;
      const Vec2 place = grid.position(i, j);
      throw Error(
          ErrorKind::refused,
          fmt::format("temperature: it strains the material by {:.3g} at x = {}, y = {}: "
                      "alphaT times the change must lie within +-{:g}",
                      own, quantity(place.x(), "m"), quantity(place.y(), "m"), max_thermal_strain),
          "take a smaller change of temperature; alphaT of glass is about 3e-6 to 9e-6/K");
    }
}

}  // namespace

ThermalStrain::ThermalStrain(const Plate& plate, const Lattice& lattice, double dt) : dt_(dt) {
  std::vector<SpreadHeat> heat = spread_heat(plate, lattice);
  if (heat.size() > 2) crowds_ = crowds_of(heat, lattice.grid);
  for (SpreadHeat& part : heat)
    parts_.push_back({part.range, std::move(part.strain), TabulatedAmplitude(part.amplitude, 0.0),
                      TabulatedCourse<double>(std::move(part.course), 0.0), std::move(part.at)});
  for (const Part& part : parts_) has_courses_ = has_courses_ || !part.course.empty();
}

void ThermalStrain::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end) {
  for (Part& part : parts_) {
    part.amplitude.tabulate(clock, begin, end, dt_);
    part.course.tabulate(clock, begin, end, dt_);
  }
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
  if (factors == factors_ && !has_courses_) return false;
  values_ = sum(lattice, scaled(state, 0));
  factors_ = std::move(factors);
  return true;
}

std::vector<double> ThermalStrain::before(const Lattice& lattice, const State& state) const {
  if (parts_.empty()) return {};
  return sum(lattice, scaled(state, state.is_start() ? 0 : -1));
}

std::vector<double> ThermalStrain::after(const Lattice& lattice, const State& state) const {
  return parts_.empty() ? std::vector<double>() : sum(lattice, scaled(state, 1));
}

bool ThermalStrain::changes_around(const State& state) const {
  return has_courses_ || factors_before(state) != factors_towards(state, 1);
}

bool ThermalStrain::changes_until(const State& state) const {
  return has_courses_ || factors_before(state) != factors_at(state, 0);
}

std::vector<ThermalStrain::Scaled> ThermalStrain::scaled(const State& state,
                                                         std::int64_t steps) const {
  const Factors factors = steps == 0 ? factors_at(state, 0) : factors_towards(state, steps);
  std::vector<Scaled> all;
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].course.empty())
      all.push_back({factors[k], {}});
    else
      all.push_back({1.0, course_of(parts_[k], state, steps)});
  return all;
}

std::vector<double> ThermalStrain::course_of(const Part& part, const State& state,
                                             std::int64_t steps) const {
  std::vector<double> strain(part.strain.size());
  const auto add = [&](std::int64_t step, double share) {
    const std::vector<double> values = part.course.at(state.clock, step, dt_);
    const double factor = share * part.amplitude.at(state.clock, step, dt_);
    for (std::size_t k = 0; k < values.size(); ++k) strain[part.at[k]] += factor * values[k];
  };
  add(state.step, steps == 0 ? 1.0 : 0.5);
  if (steps != 0) add(state.step + steps, 0.5);
  return strain;
}

std::size_t ThermalStrain::bytes() const {
  std::size_t sum = values_.size() * sizeof(double);
  for (const Part& part : parts_) sum += part.strain.size() * sizeof(double) + part.course.bytes();
  return sum;
}

std::vector<double> ThermalStrain::sum(const Lattice& lattice,
                                       const std::vector<Scaled>& scaled) const {
  const auto value = [&](std::size_t part, std::size_t place) {
    const std::vector<double>& course = scaled[part].course;
    return scaled[part].factor * (course.empty() ? parts_[part].strain : course)[place];
  };
  std::vector<double> strain(lattice.grid.nodes());
  for (std::size_t k = 0; k < parts_.size(); ++k)
    for_places(parts_[k].range, lattice.grid,
               [&](std::size_t place, std::size_t node) { strain[node] += value(k, place); });
  for (const Meeting& crowd : crowds_) {
    ExactSum sum;
    for (const auto& [part, entry] : crowd.entries) sum.add(value(part, entry));
    strain[crowd.place] = sum.value();
  }
  check(strain, lattice.grid);
  return strain;
}

}  // namespace hackle
