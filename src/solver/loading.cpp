// SPDX-License-Identifier: MIT
#include "solver/loading.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "solver/exact_sum.hpp"

namespace hackle {
namespace {

// All nodes of several lists, each once, by index.
template <class Lists>
std::vector<std::size_t> union_of(const Lists& lists, const Grid& grid) {
  std::vector<std::size_t> all;
  for (const auto& list : lists)
    for (const auto& node : list.nodes) all.push_back(grid.index(node.i, node.j));
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// Where the nodes of a list stand among all; both are ordered.
template <class Nodes>
std::vector<std::size_t> places_of(const Nodes& nodes, const Grid& grid,
                                   const std::vector<std::size_t>& all) {
  std::vector<std::size_t> at;
  at.reserve(nodes.size());
  std::size_t place = 0;
  for (const auto& node : nodes) {
    while (all[place] != grid.index(node.i, node.j)) ++place;
    at.push_back(place);
  }
  return at;
}

constexpr std::int64_t max_tabulated = 100'000'000;

// A displacement is that of the end of a step, a velocity that of its middle.
double shift_of(Support::Kind kind) {
  return kind == Support::Kind::displacement ? 1.0 : 0.5;
}

}  // namespace

void TabulatedAmplitude::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end,
                                  double dt) {
  if (!amplitude_.is_function() || begin >= end) return;
  if (end - begin > max_tabulated)
    throw Error(ErrorKind::refused,
                fmt::format("run: a function of time would be asked for {:.3g} steps beforehand, "
                            "{:.0e} are the most",
                            static_cast<double>(end - begin), static_cast<double>(max_tabulated)),
                "run in pieces, or give a table of times and factors");
  clock_ = clock;
  first_ = begin;
  table_.clear();
  table_.reserve(static_cast<std::size_t>(end - begin));
  for (std::int64_t step = begin; step < end; ++step) table_.push_back(evaluate(clock, step, dt));
}

double TabulatedAmplitude::at(const Clock& clock, std::int64_t step, double dt) const {
  const std::int64_t place = step - first_;
  if (place >= 0 && place < std::ssize(table_) && clock == clock_)
    return table_[static_cast<std::size_t>(place)];
  return evaluate(clock, step, dt);
}

Loading::Loading(const Plate& plate, const Lattice& lattice, double dt)
    : dt_(dt), impact_(plate, lattice, dt) {
  if (plate.contact) contact_.emplace(*plate.contact, lattice, dt);
  add(spread_forces(plate, lattice), lattice.grid);
  add(spread_supports(plate, lattice), lattice);
  varies_ = !prescriptions_.empty() || std::ranges::any_of(parts_, [](const Force& part) {
    return !part.amplitude.is_constant();
  });
}

void Loading::add(const std::vector<SpreadForce>& forces, const Grid& grid) {
  const std::vector<std::size_t> all = union_of(forces, grid);
  forces_.resize(all.size());
  for (const SpreadForce& force : forces) {
    Force part{places_of(force.nodes, grid, all), {}, TabulatedAmplitude(force.amplitude, 0.0)};
    for (std::size_t k = 0; k < force.nodes.size(); ++k) {
      forces_[part.at[k]] = force.nodes[k];
      part.acceleration.push_back(force.nodes[k].acceleration);
    }
    parts_.push_back(std::move(part));
  }
  find_crowds();
}

void Loading::find_crowds() {
  std::vector<const std::vector<std::size_t>*> lists;
  for (const Force& part : parts_) lists.push_back(&part.at);
  crowds_ = find_meetings(lists, forces_.size());
}

void Loading::add(const std::vector<SpreadSupport>& supports, const Lattice& lattice) {
  const Grid& grid = lattice.grid;
  const std::vector<std::size_t> all = union_of(supports, grid);
  prescribed_.assign(all.size(), PrescribedNode{0, 0, {0, 0}, false, false, 1.0});
  for (const SpreadSupport& support : supports) {
    const bool velocity = support.kind == Support::Kind::velocity;
    const double unit = (velocity ? dt_ : 1.0) / grid.dx;
    Prescription part{places_of(support.nodes, grid, all),
                      {},
                      false,
                      false,
                      support.kind,
                      TabulatedAmplitude(support.amplitude, shift_of(support.kind))};
    for (std::size_t k = 0; k < support.nodes.size(); ++k) {
      const HeldNode& node = support.nodes[k];
      PrescribedNode& prescribed = prescribed_[part.at[k]];
      prescribed.i = node.i;
      prescribed.j = node.j;
      prescribed.along_x |= node.along_x;
      prescribed.along_y |= node.along_y;
      prescribed.inertia = lattice.material_at(node.i, node.j).material.rho / lattice.rho;
      part.along_x = node.along_x;
      part.along_y = node.along_y;
      part.value.push_back(unit * node.value);
    }
    prescriptions_.push_back(std::move(part));
  }
}

void Loading::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end) {
  for (Force& part : parts_) part.amplitude.tabulate(clock, begin, end, dt_);
  for (Prescription& part : prescriptions_) part.amplitude.tabulate(clock, begin, end, dt_);
}

void Loading::begin(const Lattice& lattice, State& state) {
  impact_.begin(lattice, state);
  if (contact_) contact_->begin(lattice, state);
  fresh_ = true;
}

void Loading::follow(const Lattice& lattice, State& state, const std::vector<double>& heat,
                     std::span<const BrokenBond> broken_bonds, LoadSeconds& seconds) {
  const Stopwatch all(seconds.all);
  impact_.fly(state);
  if (!contact_) return;
  const Stopwatch watch(seconds.contact);
  contact_->take_note(lattice, state, heat, broken_bonds);
}

bool Loading::update(const Lattice& lattice, const State& state, const std::vector<double>& heat,
                     LoadSeconds& seconds) {
  const Stopwatch all(seconds.all);
  const bool changed = std::exchange(fresh_, false) || varies_;
  if (changed) {
    sum_forces([&](const Force& part) { return part.amplitude.at(state.clock, state.step, dt_); });
    prescribe(state, [&](const Prescription& part) {
      return part.amplitude.at(state.clock, state.step, dt_);
    });
  }
  const bool touched = touch(lattice, state, heat, seconds);
  if (!changed && !touched) return false;
  all_ = sum_of(forces_, impact_.forces(), lattice.grid);
  if (contact_) all_ = sum_of(all_, contact_->forces(), lattice.grid);
  return true;
}

// True when something touches, or did in the last step.
bool Loading::touch(const Lattice& lattice, const State& state, const std::vector<double>& heat,
                    LoadSeconds& seconds) {
  const auto touched = [this] {
    return !impact_.forces().empty() || (contact_ && !contact_->forces().empty());
  };
  const bool before = touched();
  if (!impact_.empty()) {
    const Stopwatch watch(seconds.impact);
    impact_.update(lattice, state);
  }
  if (contact_) {
    const Stopwatch watch(seconds.contact);
    contact_->update(lattice, state, heat);
  }
  return before || touched();
}

// v is the displacement of the step: the work of constant forces is exact, that of others of second
// order in the step.
void Loading::add_work(const Lattice& lattice, const State& state, double& work) const {
  // From m/s2 to lattice units.
  const double unit = (varies() ? 0.5 : 1.0) * dt_ * dt_ / lattice.grid.dx;
  for (const auto* forces : {&forces_, &impact_.forces()})
    for (const LoadedNode& load : *forces)
      work += load.inertia * unit * load.acceleration.dot(state.v(load.i, load.j));
}

void Loading::halt(const State& state, double passed) {
  const double now = state.clock.time(state.step, 0.0, dt_);
  fresh_ = true;
  sum_forces([&](const Force& part) { return part.amplitude.amplitude().at(now); });
  all_ = forces_;
  prescribe(state, [&](const Prescription& part) {
    const Amplitude& amplitude = part.amplitude.amplitude();
    if (part.kind == Support::Kind::displacement) return amplitude.at(now);
    return passed > 0.0 ? passed / dt_ * amplitude.mean(now - passed, now) : 0.0;
  });
}

template <class Factor>
void Loading::sum_forces(const Factor& factor_of) {
  for (LoadedNode& node : forces_) node.acceleration = {0, 0};
  std::vector<double> factors;
  for (const Force& part : parts_) {
    const double factor = factors.emplace_back(factor_of(part));
    for (std::size_t k = 0; k < part.at.size(); ++k)
      forces_[part.at[k]].acceleration += factor * part.acceleration[k];
  }
  for (const Meeting& crowd : crowds_) {
    ExactVectorSum sum;
    for (const auto& [part, entry] : crowd.entries)
      sum.add(factors[part] * parts_[part].acceleration[entry]);
    forces_[crowd.place].acceleration = sum.value();
  }
}

// Where several supports hold a node along one axis, the last one does.
template <class Factor>
void Loading::prescribe(const State& state, const Factor& factor_of) {
  for (const Prescription& part : prescriptions_) {
    const double factor = factor_of(part);
    for (std::size_t k = 0; k < part.at.size(); ++k) {
      PrescribedNode& node = prescribed_[part.at[k]];
      Vec2 move = factor * part.value[k];
      if (part.kind == Support::Kind::displacement) move -= state.origin + state.u(node.i, node.j);
      if (part.along_x) node.move.x() = move.x();
      if (part.along_y) node.move.y() = move.y();
    }
  }
}

}  // namespace hackle
