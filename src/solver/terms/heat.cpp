// SPDX-License-Identifier: MIT
#include "solver/terms/heat.hpp"

#include "solver/terms/heat_work.hpp"
#include "solver/terms/makers.hpp"

namespace hackle {

std::unique_ptr<Term> make_heat(const Plate& plate, const Lattice& lattice, double dt) {
  ThermalStrain strain(plate, lattice, dt);
  return strain.empty() ? nullptr : std::make_unique<Heat>(std::move(strain));
}

// Counts the work of heating from half a step before now to half a step after.
double Heat::before_step(const Surroundings& around, State& state, double kick) {
  if (strain_.changes_around(state))
    state.external_work += work_of_heating(around, state, strain_.before(around.lattice, state),
                                           strain_.after(around.lattice, state));
  return kick;
}

void Heat::follow(const Surroundings& around, State& state) {
  if (strain_.update(around.lattice, state))
    around.stepper.set_heat(around.lattice, strain_.values());
}

void Heat::add_open(const Surroundings& around, const State& state, Ledger& ledger) const {
  if (strain_.changes_until(state))
    ledger.external +=
        work_of_heating(around, state, strain_.before(around.lattice, state), strain_.values());
}

double work_of_heating(const Surroundings& around, const State& state,
                       const std::vector<double>& before, const std::vector<double>& after) {
  double work = heat_work(around.lattice, state, before, after, around.threads, around.slab) /
                around.energy_unit();
  for (const Cloned<Term>& term : around.terms) work += term->heat_work(before, after);
  return work;
}

}  // namespace hackle
