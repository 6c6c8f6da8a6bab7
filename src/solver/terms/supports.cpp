// SPDX-License-Identifier: MIT
#include "solver/terms/supports.hpp"

#include <utility>

#include "scene/load_names.hpp"
#include "solver/terms/bearing.hpp"
#include "solver/terms/makers.hpp"
#include "solver/terms/node_force.hpp"
#include "solver/terms/node_lists.hpp"

namespace hackle {
namespace {

// A displacement refers to the end of a step, a velocity to its middle.
double shift_of(Support::Kind kind) {
  return kind == Support::Kind::displacement ? 1.0 : 0.5;
}

}  // namespace

std::unique_ptr<Term> make_supports(const Plate& plate, const Lattice& lattice, double dt) {
  const std::vector<SpreadSupport> supports = spread_supports(plate, lattice);
  if (supports.empty()) return nullptr;
  std::vector<std::string> names;
  for (const Support& support : plate.loads.supports)
    names.push_back(
        load_name(support.name, description_of<Support>.noun, static_cast<int>(names.size()) + 1));
  return std::make_unique<Supports>(supports, names, lattice, dt);
}

Supports::Supports(const std::vector<SpreadSupport>& supports,
                   const std::vector<std::string>& names, const Lattice& lattice, double dt) {
  const std::vector<std::size_t> all = union_of(supports, lattice.grid);
  prescribed_.assign(all.size(), PrescribedNode{0, 0, {0, 0}, false, false, 1.0});
  holders_.resize(all.size());
  for (std::size_t k = 0; k < supports.size(); ++k) add(supports[k], names[k], all, lattice, dt);
}

void Supports::add(const SpreadSupport& support, const std::string& name,
                   const std::vector<std::size_t>& all, const Lattice& lattice, double dt) {
  const auto number = static_cast<int>(parts_.size());
  const Grid& grid = lattice.grid;
  const double unit = (support.kind == Support::Kind::velocity ? dt : 1.0) / grid.dx;
  Part part{places_of(support.nodes, grid, all),
            {},
            false,
            false,
            support.kind,
            TabulatedAmplitude(support.amplitude, shift_of(support.kind)),
            TabulatedCourse<Vec2>(support.course, shift_of(support.kind)),
            unit,
            name};
  for (std::size_t k = 0; k < support.nodes.size(); ++k) {
    const HeldNode& node = support.nodes[k];
    PrescribedNode& prescribed = prescribed_[part.at[k]];
    prescribed.i = node.i;
    prescribed.j = node.j;
    prescribed.along_x |= node.along_x;
    prescribed.along_y |= node.along_y;
    prescribed.inertia = lattice.material_at(node.i, node.j).material.rho / lattice.rho;
    if (node.along_x) holders_[part.at[k]].along_x = number;
    if (node.along_y) holders_[part.at[k]].along_y = number;
    part.along_x = node.along_x;
    part.along_y = node.along_y;
    part.value.push_back(unit * node.value);
  }
  parts_.push_back(std::move(part));
}

void Supports::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt) {
  for (Part& part : parts_) {
    part.amplitude.tabulate(clock, begin, end, dt);
    part.course.tabulate(clock, begin, end, dt);
  }
}

template <class Values>
void Supports::follow_courses(const Values& values_of) {
  for (Part& part : parts_) {
    if (part.course.empty()) continue;
    part.value = values_of(part);
    for (Vec2& value : part.value) value *= part.unit;
  }
}

bool Supports::update(const Surroundings& around, State& state) {
  follow_courses([&](Part& part) { return part.course.at(state.clock, state.step, around.dt); });
  prescribe(state, [&](const Part& part) {
    return part.amplitude.at(state.clock, state.step, around.dt);
  });
  return true;
}

void Supports::halt(const Surroundings& around, const State& state, double passed) {
  const double now = state.clock.time(state.step, 0.0, around.dt);
  follow_courses([&](const Part& part) {
    const bool led = part.kind == Support::Kind::velocity;
    return values_at(part.course.course(), led ? now - 0.5 * passed : now);
  });
  prescribe(state, [&](const Part& part) {
    const Amplitude& amplitude = part.amplitude.amplitude();
    if (part.kind == Support::Kind::displacement) return amplitude.at(now);
    return passed > 0.0 ? passed / around.dt * amplitude.mean(now - passed, now) : 0.0;
  });
}

// If several supports hold a node along one axis, the last one applies.
template <class Factor>
void Supports::prescribe(const State& state, const Factor& factor_of) {
  for (const Part& part : parts_) {
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

std::size_t Supports::bytes() const {
  std::size_t sum = 0;
  for (const Part& part : parts_) sum += part.course.bytes();
  return sum;
}

void Supports::add_work(const Surroundings& around, const State&, WorkOf part, double& work) const {
  if (part != WorkOf::second_half) work += around.stepper.prescribed_work();
}

void Supports::add_open(const Surroundings& around, const State& state, Ledger& ledger) const {
  if (state.is_start()) return;
  const std::vector<Vec2> a = around.stepper.accelerations(around.lattice, state);
  double sum = 0.0;
  for (const PrescribedNode& node : prescribed_) {
    const Vec2& push = a[around.lattice.grid.index(node.i, node.j)];
    const Vec2 v = state.v(node.i, node.j);
    if (node.along_x) sum -= node.inertia * push.x() * v.x();
    if (node.along_y) sum -= node.inertia * push.y() * v.y();
  }
  ledger.external += 0.5 * sum;
}

namespace {

// Returns the acceleration of a node without its support, in lattice units.
Vec2 free_acceleration(const Surroundings& around, const State& state, int i, int j) {
  Vec2 sum = pull_of_bonds(around.lattice, state, around.heat, around.dt, i, j);
  for (const Cloned<Term>& term : around.terms)
    if (const auto* load = entry_of(term->forces(), i, j, around.lattice.grid))
      sum += around.dt * around.dt / around.lattice.grid.dx * load->acceleration;
  return sum;
}

// Returns the force that a held node puts on what holds it: what would accelerate it, less what
// does. A plate that stands has no acceleration yet.
Vec2 borne_by(const PrescribedNode& node, const Surroundings& around, const State& state) {
  const Vec2 led = state.is_start() ? Vec2(0, 0) : Vec2(node.move - state.v(node.i, node.j));
  return node.inertia * (free_acceleration(around, state, node.i, node.j) - led);
}

}  // namespace

void Supports::add_reactions(const Surroundings& around, const State& state,
                             std::vector<Reaction>& list) const {
  const Grid& grid = around.lattice.grid;
  std::vector<Bearing> sums(parts_.size());
  for (std::size_t k = 0; k < prescribed_.size(); ++k) {
    const PrescribedNode& node = prescribed_[k];
    const Vec2 u = state.origin + state.u(node.i, node.j);
    const Vec2 place = grid.from_centre(node.i, node.j) + u;
    const Vec2 force = borne_by(node, around, state);
    const auto bear = [&](int holder, const Vec2& share) {
      if (holder < 0) return;
      sums[static_cast<std::size_t>(holder)].add(place, share);
      sums[static_cast<std::size_t>(holder)].count(place, u);
    };
    bear(holders_[k].along_x, {force.x(), 0});
    bear(holders_[k].along_y, {0, force.y()});
  }
  for (std::size_t k = 0; k < parts_.size(); ++k)
    list.push_back(sums[k].reaction(parts_[k].name, description_of<Support>.noun,
                                    static_cast<int>(k) + 1, grid, around.energy_unit() / grid.dx));
}

}  // namespace hackle
