// SPDX-License-Identifier: MIT
#include "solver/terms/heat_work.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hackle {
namespace {

// Values of the nodes of a row of bonds, by Grid::index.
struct NodeValues {
  std::vector<double> before, after;  // thermal strain
  std::vector<double> half;           // of the micromodulus, N/m6
};

NodeValues node_values(const Lattice& lattice, const std::vector<double>& before,
                       const std::vector<double>& after) {
  const std::size_t nodes = lattice.grid.nodes();
  NodeValues values{before, after, std::vector<double>(nodes, 0.5 * lattice.calibration.c)};
  values.before.resize(nodes);
  values.after.resize(nodes);
  if (!lattice.is_mixed()) return values;
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i)
      values.half[lattice.grid.index(i, j)] = 0.5 * lattice.micromodulus_at(i, j);
  return values;
}

// For the bonds of one offset that row j keeps: adds |xi| w c (s^2 after - s^2 before) of each to
// the sum of its column. Columns have separate sums so that the compiler may vectorise.
template <class Real>
void add_row(const Lattice& lattice, const Motion<Real>& motion, const std::uint32_t* words,
             const NodeValues& values, int j, int a, int b, const Vec2& xi, double cost,
             std::uint32_t shift, double* sums) {
  const Grid& grid = lattice.grid;
  const int first = std::max(0, -a), end = std::min(grid.nx, grid.nx - a);
  const std::ptrdiff_t at = grid.layout().at(0, j), to = b * grid.layout().stride() + a;
  const Real *ux = motion.ux.data() + at, *uy = motion.uy.data() + at;
  const std::size_t here = grid.index(0, j), there = grid.index(0, j + b);
  const double *old_here = values.before.data() + here, *old_there = values.before.data() + there;
  const double *new_here = values.after.data() + here, *new_there = values.after.data() + there;
  const double *c_here = values.half.data() + here, *c_there = values.half.data() + there;
  const double x = xi.x(), y = xi.y(), inverse_L2 = 1.0 / xi.squaredNorm();
  for (int i = first; i < end; ++i) {
    const double hx = static_cast<double>(ux[i + to]) - static_cast<double>(ux[i]);
    const double hy = static_cast<double>(uy[i + to]) - static_cast<double>(uy[i]);
    const double squared = 1.0 + (hx * (hx + 2.0 * x) + hy * (hy + 2.0 * y)) * inverse_L2;
    const double was = squared - (old_here[i] + old_there[i + a]);
    const double is = squared - (new_here[i] + new_there[i + a]);
    const double s_was = std::sqrt(was > 0.0 ? was : 0.0), s_is = std::sqrt(is > 0.0 ? is : 0.0);
    const auto held = static_cast<double>(static_cast<int>((words[at + i] >> shift) & 1U));
    sums[i] += held * cost * (c_here[i] + c_there[i + a]) * (s_is - s_was) * (s_is + s_was - 2.0);
  }
}

}  // namespace

double heat_work(const Lattice& lattice, const State& state, const std::vector<double>& before,
                 const std::vector<double>& after, const Threads& threads, const Slab& slab) {
  const NodeValues values = node_values(lattice, before, after);
  const Grid& grid = lattice.grid;
  std::vector<double> of_row(static_cast<std::size_t>(grid.ny));
  std::visit(
      [&](const auto& motion) {
        const int begin = slab.begin();
        threads.for_tasks(slab.end(grid.ny) - begin, [&](int row, int) {
          const int j = begin + row;
          std::vector<double> sums(static_cast<std::size_t>(grid.nx));
          lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
            if (j + b >= grid.ny) return;
            const auto plane = static_cast<std::size_t>(bit / 32) * state.bonds.plane();
            add_row(lattice, motion, state.bonds.words().data() + plane, values, j, a, b, xi,
                    weight * xi.norm(), static_cast<std::uint32_t>(bit % 32), sums.data());
          });
          of_row[static_cast<std::size_t>(j)] = std::accumulate(sums.begin(), sums.end(), 0.0);
        });
      },
      state.motion);
  complete_rows(slab, of_row);
  // Half from the micropotential; V^2 |xi| is dx^5.
  return 0.5 * std::pow(grid.dx, 5) * std::accumulate(of_row.begin(), of_row.end(), 0.0);
}

}  // namespace hackle
