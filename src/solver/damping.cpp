// SPDX-License-Identifier: MIT
#include "solver/damping.hpp"

#include <numeric>
#include <vector>

namespace hackle {
namespace {

// Of row j; returns the sum of squares before, times the density over that of the plate.
template <class Real>
double damp_row(const Lattice& lattice, Real keep, int j, Motion<Real>& motion) {
  const Grid& grid = lattice.grid;
  double sum = 0.0;
  for (int i = 0; i < grid.nx; ++i) {
    const auto at = static_cast<std::size_t>(grid.layout().at(i, j));
    const double vx = motion.vx[at], vy = motion.vy[at];
    const double inertia = lattice.material.empty() || lattice.is_void(i, j)
                               ? 1.0
                               : lattice.material_at(i, j).material.rho / lattice.rho;
    sum += inertia * (vx * vx + vy * vy);
    motion.vx[at] *= keep;
    motion.vy[at] *= keep;
  }
  return sum;
}

}  // namespace

double damp(const Lattice& lattice, double keep, const Threads& threads, State& state) {
  std::vector<double> of_row(static_cast<std::size_t>(lattice.grid.ny));
  constexpr int rows_per_task = 16;
  std::visit(
      [&]<class Real>(Motion<Real>& motion) {
        const int ny = lattice.grid.ny;
        threads.for_tasks((ny + rows_per_task - 1) / rows_per_task, [&](int task, int) {
          for (int j = task * rows_per_task; j < std::min(ny, (task + 1) * rows_per_task); ++j)
            of_row[static_cast<std::size_t>(j)] =
                damp_row(lattice, static_cast<Real>(keep), j, motion);
        });
      },
      state.motion);
  return 0.5 * (1.0 - keep * keep) * std::accumulate(of_row.begin(), of_row.end(), 0.0);
}

}  // namespace hackle
