// SPDX-License-Identifier: MIT
#include "solver/terms/damping.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "solver/node_vectors.hpp"
#include "solver/terms/makers.hpp"

namespace hackle {
namespace {

template <class Real>
double square_of_row(const Lattice& lattice, int j, const Motion<Real>& motion) {
  const Grid& grid = lattice.grid;
  double sum = 0.0;
  for (int i = 0; i < grid.nx; ++i) {
    const auto at = static_cast<std::size_t>(grid.layout().at(i, j));
    const double vx = motion.vx[at], vy = motion.vy[at];
    const double inertia = lattice.material.empty() || lattice.is_void(i, j)
                               ? 1.0
                               : lattice.material_at(i, j).material.rho / lattice.rho;
    sum += inertia * (vx * vx + vy * vy);
  }
  return sum;
}

// Returns the prescribed components of v.
Vec2 prescribed_part(const PrescribedNode& node, const Vec2& v) {
  return {node.along_x ? v.x() : 0.0, node.along_y ? v.y() : 0.0};
}

}  // namespace

Damping::Damping(double x) {
  if (!(x > 0.0)) return;
  keep = std::exp(-x);
  yield = -std::expm1(-x) / x;
  loss = x;
  first = 0.5 - x / (2.0 * std::sinh(x));
  last = x / -std::expm1(-2.0 * x) - 0.5 * keep;
}

namespace {

// Calls work(j) for the rows of the slab.
template <class Work>
void for_own_rows(const Surroundings& around, const Work& work) {
  const int begin = around.slab.begin(), end = around.slab.end(around.lattice.grid.ny);
  for_rows(around.threads, end - begin, [&](int row) { work(begin + row); });
}

}  // namespace

double free_motion(const Surroundings& around, std::span<const PrescribedNode> prescribed,
                   const State& state) {
  std::vector<double> of_row(static_cast<std::size_t>(around.lattice.grid.ny));
  std::visit(
      [&](const auto& motion) {
        for_own_rows(around, [&](int j) {
          of_row[static_cast<std::size_t>(j)] = square_of_row(around.lattice, j, motion);
        });
      },
      state.motion);
  complete_rows(around.slab, of_row);
  RowSum led(around.slab);
  for (const PrescribedNode& node : prescribed)
    if (around.slab.owns(node.j))
      led.add(node.j, node.inertia * prescribed_part(node, state.v(node.i, node.j)).squaredNorm());
  return std::max(std::accumulate(of_row.begin(), of_row.end(), 0.0) - led.value(), 0.0);
}

void damp(const Surroundings& around, std::span<const PrescribedNode> prescribed, double keep,
          State& state) {
  std::vector<Vec2> before;
  before.reserve(prescribed.size());
  for (const PrescribedNode& node : prescribed) before.push_back(state.v(node.i, node.j));
  std::visit(
      [&]<class Real>(Motion<Real>& motion) {
        const Grid& grid = around.lattice.grid;
        for_own_rows(around, [&](int j) {
          const auto at = static_cast<std::size_t>(grid.layout().at(0, j));
          for (std::size_t n = at; n < at + static_cast<std::size_t>(grid.nx); ++n) {
            motion.vx[n] *= static_cast<Real>(keep);
            motion.vy[n] *= static_cast<Real>(keep);
          }
        });
      },
      state.motion);
  for (std::size_t k = 0; k < prescribed.size(); ++k) {
    const PrescribedNode& node = prescribed[k];
    const Vec2 damped = state.v(node.i, node.j);
    state.set_v(
        node.i, node.j,
        {node.along_x ? before[k].x() : damped.x(), node.along_y ? before[k].y() : damped.y()});
  }
}

std::unique_ptr<Term> make_damping(const Plate& plate, const Lattice&, double) {
  const double rate = plate.loads.damping;
  return rate > 0.0 ? std::make_unique<ViscousDamping>(rate) : nullptr;
}

std::span<const PrescribedNode> prescribed_in(const Surroundings& around) {
  for (const Cloned<Term>& term : around.terms)
    if (!term->prescribed().empty()) return term->prescribed();
  return {};
}

double ViscousDamping::before_step(const Surroundings& around, State& state, double kick) {
  const Damping step(rate_ * around.dt), half(0.5 * rate_ * around.dt);
  const std::span<const PrescribedNode> prescribed = prescribed_in(around);
  const bool starts = state.is_start();
  state.damped += (starts ? step.first : step.loss) * free_motion(around, prescribed, state);
  damp(around, prescribed, starts ? half.keep : step.keep, state);
  return kick * (starts ? half.yield : step.yield);
}

void ViscousDamping::add_open(const Surroundings& around, const State& state,
                              Ledger& ledger) const {
  if (state.is_start()) return;
  ledger.damped +=
      Damping(rate_ * around.dt).last * free_motion(around, prescribed_in(around), state);
}

double ViscousDamping::lost_in_half_step(const Surroundings& around, const State& state) const {
  if (state.is_start()) return 0.0;
  return 0.5 * Damping(rate_ * around.dt).loss * free_motion(around, prescribed_in(around), state);
}

}  // namespace hackle
