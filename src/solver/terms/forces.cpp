// SPDX-License-Identifier: MIT
#include "solver/terms/forces.hpp"

#include <algorithm>
#include <utility>

#include "solver/exact_sum.hpp"
#include "solver/terms/makers.hpp"
#include "solver/terms/node_lists.hpp"

namespace hackle {

std::unique_ptr<Term> make_forces(const Plate& plate, const Lattice& lattice, double) {
  const std::vector<SpreadForce> forces = spread_forces(plate, lattice);
  return forces.empty() ? nullptr : std::make_unique<Forces>(forces, lattice.grid);
}

Forces::Forces(const std::vector<SpreadForce>& forces, const Grid& grid) {
  const std::vector<std::size_t> all = union_of(forces, grid);
  forces_.resize(all.size());
  for (const SpreadForce& force : forces) {
    Part part{places_of(force.nodes, grid, all),
              {},
              TabulatedAmplitude(force.amplitude, 0.0),
              TabulatedCourse<Vec2>(force.course, 0.0)};
    for (std::size_t k = 0; k < force.nodes.size(); ++k) {
      forces_[part.at[k]] = force.nodes[k];
      part.acceleration.push_back(force.nodes[k].acceleration);
    }
    varies_ = varies_ || !part.amplitude.is_constant() || !part.course.empty();
    parts_.push_back(std::move(part));
  }
  find_crowds();
}

void Forces::find_crowds() {
  std::vector<const std::vector<std::size_t>*> lists;
  for (const Part& part : parts_) lists.push_back(&part.at);
  crowds_ = find_meetings(lists, forces_.size());
}

void Forces::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt) {
  for (Part& part : parts_) {
    part.amplitude.tabulate(clock, begin, end, dt);
    part.course.tabulate(clock, begin, end, dt);
  }
}

bool Forces::update(const Surroundings& around, State& state) {
  if (!std::exchange(fresh_, false) && !varies_) return false;
  for (Part& part : parts_)
    if (!part.course.empty())
      part.acceleration = part.course.at(state.clock, state.step, around.dt);
  sum([&](const Part& part) { return part.amplitude.at(state.clock, state.step, around.dt); });
  return true;
}

void Forces::halt(const Surroundings& around, const State& state, double) {
  const double now = state.clock.time(state.step, 0.0, around.dt);
  fresh_ = true;
  for (Part& part : parts_)
    if (!part.course.empty()) part.acceleration = values_at(part.course.course(), now);
  sum([&](const Part& part) { return part.amplitude.amplitude().at(now); });
}

template <class Factor>
void Forces::sum(const Factor& factor_of) {
  for (LoadedNode& node : forces_) node.acceleration = {0, 0};
  std::vector<double> factors;
  for (const Part& part : parts_) {
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

std::size_t Forces::bytes() const {
  std::size_t sum = 0;
  for (const Part& part : parts_) sum += part.course.bytes();
  return sum;
}

void Forces::add_work(const Surroundings& around, const State& state, WorkOf part,
                      double& work) const {
  add_work_of(forces_, around, state, part, work);
}

void add_work_of(std::span<const LoadedNode> forces, const Surroundings& around, const State& state,
                 WorkOf part, double& work) {
  // From m/s2 to lattice units.
  const double unit =
      (part == WorkOf::whole_step ? 1.0 : 0.5) * around.dt * around.dt / around.lattice.grid.dx;
  RowSum sum(around.slab, work);
  for (const LoadedNode& load : forces)
    if (around.slab.owns(load.j))
      sum.add(load.j, load.inertia * unit * load.acceleration.dot(state.v(load.i, load.j)));
  work = sum.value();
}

}  // namespace hackle
