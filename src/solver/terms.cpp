// SPDX-License-Identifier: MIT
#include "solver/terms.hpp"

#include <algorithm>
#include <utility>

#include "base/stopwatch.hpp"
#include "solver/terms/damping.hpp"
#include "solver/terms/forces.hpp"
#include "solver/terms/makers.hpp"

namespace hackle {

Terms::Terms(const Plate& plate, const Lattice& lattice, double dt) {
  for (MakeTerm* make : term_makers) add(make(plate, lattice, dt));
}

void Terms::add(std::unique_ptr<Term> term) {
  if (!term) return;
  list_.emplace_back(std::move(term));
  seconds_.push_back(0.0);
}

void Terms::set_damping(double rate) {
  if (find<ViscousDamping>() != nullptr) {
    list_.erase(list_.begin());
    seconds_.erase(seconds_.begin());
  }
  if (!(rate > 0.0)) return;
  list_.emplace(list_.begin(), std::make_unique<ViscousDamping>(rate));
  seconds_.insert(seconds_.begin(), 0.0);
}

const std::vector<double>& Terms::thermal_strain() const {
  static const std::vector<double> none;
  for (const Cloned<Term>& term : list_)
    if (const std::vector<double>* strain = term->thermal_strain()) return *strain;
  return none;
}

void Terms::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt) {
  for (Cloned<Term>& term : list_) term->tabulate(clock, begin, end, dt);
}

void Terms::begin(const Surroundings& around, State& state) {
  for (Cloned<Term>& term : list_) term->begin(around, state);
}

double Terms::before_step(const Surroundings& around, State& state) {
  double kick = state.is_start() ? 0.5 : 1.0;
  for (std::size_t k = 0; k < list_.size(); ++k) {
    const Stopwatch watch(seconds_[k]);
    kick = list_[k]->before_step(around, state, kick);
  }
  return kick;
}

void Terms::follow(const Surroundings& around, State& state) {
  for (std::size_t k = 0; k < list_.size(); ++k) {
    const Stopwatch watch(seconds_[k]);
    list_[k]->follow(around, state);
  }
}

bool Terms::update(const Surroundings& around, State& state) {
  bool changed = false;
  for (std::size_t k = 0; k < list_.size(); ++k) {
    const Stopwatch watch(seconds_[k]);
    changed |= list_[k]->update(around, state);
  }
  if (changed) gather(around.lattice.grid, false);
  return changed;
}

void Terms::gather(const Grid& grid, bool at_rest) {
  actions_.forces.clear();
  actions_.prescribed.clear();
  for (const Cloned<Term>& term : list_) {
    if (at_rest && !term->acts_at_rest()) continue;
    if (!term->forces().empty()) actions_.forces = sum_of(actions_.forces, term->forces(), grid);
    if (!term->prescribed().empty())
      actions_.prescribed.assign(term->prescribed().begin(), term->prescribed().end());
  }
}

bool Terms::keep_to_rows() const {
  return std::ranges::all_of(list_, [](const Cloned<Term>& term) { return term->keeps_to_rows(); });
}

bool Terms::vary() const {
  return std::ranges::any_of(list_, [](const Cloned<Term>& term) { return term->varies(); });
}

void Terms::add_work(const Surroundings& around, State& state, WorkOf part) const {
  double dragged = 0.0;
  for (const Cloned<Term>& term : list_) {
    term->add_work(around, state, part, state.external_work);
    if (term->resists()) add_work_of(term->drag(), around, state, part, dragged);
  }
  state.damped -= dragged;
}

double Terms::drag_of_half_step(const Surroundings& around, const State& state) const {
  double work = 0.0;
  for (const Cloned<Term>& term : list_)
    add_work_of(term->drag(), around, state, WorkOf::second_half, work);
  return state.is_start() ? 0.0 : -work;
}

void Terms::check_rest(const std::string& who) const {
  for (const Cloned<Term>& term : list_) term->check_rest(who);
}

void Terms::halt(const Surroundings& around, const State& state, double passed) {
  for (Cloned<Term>& term : list_) term->halt(around, state, passed);
  gather(around.lattice.grid, true);
}

double Terms::stored() const {
  double sum = 0.0;
  for (const Cloned<Term>& term : list_) sum += term->stored();
  return sum;
}

Ledger Terms::ledger(const Surroundings& around, const State& state) const {
  Ledger ledger{state.external_work, state.damped, state.released, stored() + state.contact_lost};
  for (const Cloned<Term>& term : list_) term->add_open(around, state, ledger);
  return ledger;
}

std::vector<Reaction> Terms::reactions(const Surroundings& around, const State& state) const {
  std::vector<Reaction> list;
  for (const Cloned<Term>& term : list_) term->add_reactions(around, state, list);
  const auto is_body = [](const Reaction& one) {
    return one.who != "support" && one.who != "foundation";
  };
  std::stable_partition(list.begin(), list.end(), is_body);
  return list;
}

std::vector<TermSeconds> Terms::seconds() const {
  std::vector<TermSeconds> all;
  const auto add = [&](std::string_view name, double seconds) {
    if (name.empty()) return;
    const auto same = std::ranges::find(all, name, &TermSeconds::name);
    (same == all.end() ? all.emplace_back(TermSeconds{name}) : *same).seconds += seconds;
  };
  for (std::size_t k = 0; k < list_.size(); ++k) add(list_[k]->name(), seconds_[k]);
  for (const TermSeconds& part : earlier_) add(part.name, part.seconds);
  return all;
}

std::size_t Terms::bytes() const {
  std::size_t sum = 0;
  for (const Cloned<Term>& term : list_) sum += term->bytes();
  return sum;
}

}  // namespace hackle
