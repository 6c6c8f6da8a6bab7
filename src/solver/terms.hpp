// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/terms/term.hpp"

namespace hackle {

// Wall time of a part of a step that not every scene has, s.
struct TermSeconds {
  std::string_view name;
  double seconds = 0.0;
};

// The terms that a scene uses, in the order in which they act, and what they do together.
class Terms {
 public:
  // Throws what functions of place throw, and Error (refused) for loads that find no node and for
  // discs too small or too light for the spacing.
  Terms(const Plate& plate, const Lattice& lattice, double dt);

  std::span<const Cloned<Term>> list() const { return list_; }
  // The only term of a type, or nullptr.
  template <class T>
  const T* find() const {
    for (const Cloned<Term>& term : list_)
      if (const auto* found = dynamic_cast<const T*>(&*term)) return found;
    return nullptr;
  }
  const std::vector<double>& thermal_strain() const;  // by Grid::index; empty: nothing is heated

  void set_damping(double rate);  // 1/s; 0: none

  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt);

  // See Term for each of these.
  void begin(const Surroundings& around, State& state);
  double before_step(const Surroundings& around, State& state);
  void follow(const Surroundings& around, State& state);
  bool update(const Surroundings& around, State& state);
  void add_work(const Surroundings& around, State& state, WorkOf part) const;
  // What drag has taken in the second half of the last step, in units of rho dx^4/dt^2.
  double drag_of_half_step(const Surroundings& around, const State& state) const;
  // Adds the wall time of terms that these replace to theirs.
  void go_on_from(const Terms& other) { earlier_ = other.seconds(); }
  bool keep_to_rows() const;  // all of them do
  bool vary() const;          // one of them does: the work of all forces is counted in halves
  void check_rest(const std::string& who) const;
  // Contacts and impacts take no part.
  void halt(const Surroundings& around, const State& state, double passed);

  double stored() const;  // by all of them, in units of rho dx^4/dt^2
  // The ledger of a state, in units of rho dx^4/dt^2.
  Ledger ledger(const Surroundings& around, const State& state) const;
  std::vector<Reaction> reactions(const Surroundings& around, const State& state) const;
  // What update() or halt() found.
  const Actions& actions() const { return actions_; }
  std::vector<TermSeconds> seconds() const;
  std::size_t bytes() const;

 private:
  void add(std::unique_ptr<Term> term);
  void gather(const Grid& grid, bool at_rest);

  std::vector<Cloned<Term>> list_;
  std::vector<double> seconds_;       // of each
  std::vector<TermSeconds> earlier_;  // of terms that these replaced
  Actions actions_;
};

}  // namespace hackle
