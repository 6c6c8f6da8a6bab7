// SPDX-License-Identifier: MIT
#include "solver/terms/supports.hpp"

#include <utility>

#include "solver/terms/makers.hpp"
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
  return supports.empty() ? nullptr : std::make_unique<Supports>(supports, lattice, dt);
}

Supports::Supports(const std::vector<SpreadSupport>& supports, const Lattice& lattice, double dt) {
  const std::vector<std::size_t> all = union_of(supports, lattice.grid);
  prescribed_.assign(all.size(), PrescribedNode{0, 0, {0, 0}, false, false, 1.0});
  for (const SpreadSupport& support : supports) add(support, all, lattice, dt);
}

void Supports::add(const SpreadSupport& support, const std::vector<std::size_t>& all,
                   const Lattice& lattice, double dt) {
  const Grid& grid = lattice.grid;
  const double unit = (support.kind == Support::Kind::velocity ? dt : 1.0) / grid.dx;
  Part part{places_of(support.nodes, grid, all),
            {},
            false,
            false,
            support.kind,
            TabulatedAmplitude(support.amplitude, shift_of(support.kind)),
            TabulatedCourse<Vec2>(support.course, shift_of(support.kind)),
            unit};
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

}  // namespace hackle
