// SPDX-License-Identifier: MIT
// Changes of temperature: what bonds feel of them, and the work they do (src/solver/README.md 3.6).
#pragma once

#include <utility>

#include "solver/terms/term.hpp"
#include "solver/terms/thermal_strain.hpp"

namespace hackle {

class Heat final : public Term {
 public:
  explicit Heat(ThermalStrain strain) : strain_(std::move(strain)) {}

  std::unique_ptr<Term> clone() const override { return std::make_unique<Heat>(*this); }
  std::string_view name() const override { return "heat"; }
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double) override {
    strain_.tabulate(clock, begin, end);
  }
  // Throws what ThermalStrain::update throws.
  void begin(const Surroundings& around, State& state) override {
    strain_.update(around.lattice, state);
  }
  bool keeps_to_rows() const override { return true; }
  double before_step(const Surroundings& around, State& state, double kick) override;
  void follow(const Surroundings& around, State& state) override;
  const std::vector<double>* thermal_strain() const override { return &strain_.values(); }
  void add_open(const Surroundings& around, const State& state, Ledger& ledger) const override;
  void halt(const Surroundings& around, const State& state, double) override {
    strain_.update(around.lattice, state);
  }
  std::size_t bytes() const override { return strain_.bytes(); }

  const ThermalStrain& strain() const { return strain_; }

 private:
  ThermalStrain strain_;
};

// What the bonds and terms of a plate store more when the thermal strain of its nodes changes, in
// units of rho dx^4/dt^2. `before` and `after` are by Grid::index; empty means 0.
double work_of_heating(const Surroundings& around, const State& state,
                       const std::vector<double>& before, const std::vector<double>& after);

}  // namespace hackle
