// SPDX-License-Identifier: MIT
// How a plate comes to rest: under the loads of a moment, or again and again while they grow
// (src/solver/README.md 8).
#pragma once

#include <vector>

#include "solver/moving_plate.hpp"
#include "solver/statics/rest.hpp"
#include "solver/statics/static_equilibrium.hpp"

namespace hackle {

struct Equilibrium;

class Statics {
 public:
  explicit Statics(MovingPlate& plate) : plate_(plate) {}

  // See Simulation::relax. The plate is as it was when it throws.
  RelaxResult relax(const RelaxOptions& options);
  // One increment of slow loading, which ends at `end`, s: see Simulation::load_slowly. The plate
  // is as it was, though not at its start, when it throws.
  void load_to(double end, const QuasistaticOptions& options, QuasistaticResult& result);

 private:
  // The loads on the plate before the static equilibrium.
  struct Departure {
    std::vector<LoadedNode> loads;  // whose work is counted up to here
    std::vector<double> heat;       // thermal strain
    RigidContacts contacts;         // with rollers and platens
  };

  void check(const RelaxOptions& options) const;
  Departure depart(const RelaxOptions& options);
  StaticEquilibrium equilibrium(const RelaxOptions& options) const;
  Equilibrium go_to_rest(const Departure& from, StaticEquilibrium& equilibrium,
                         const RelaxOptions& options);
  Equilibrium settle(StaticEquilibrium& equilibrium, const RelaxOptions& options);
  RelaxOptions options_of_increment(const QuasistaticOptions& options,
                                    const QuasistaticResult& result) const;
  void break_and_settle(double end, const QuasistaticOptions& options, QuasistaticResult& result,
                        std::vector<BrokenBond>& broken_bonds);
  // J/m of StaticWork, in the unit of the state's ledger.
  double unit_of_work() const;

  MovingPlate& plate_;
};

}  // namespace hackle
