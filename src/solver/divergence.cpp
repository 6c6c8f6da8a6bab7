// SPDX-License-Identifier: MIT
#include "solver/divergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

[[noreturn]] void throw_diverged(const View& view, int i, int j) {
  const Vec2 place = view.lattice().grid.position(i, j);
  throw Error(ErrorKind::run_failed,
              fmt::format("the solution has diverged by step {}, at {}, at ({}, {}): the step "
                          "is {}, its limit {}",
                          view.state().step, quantity(view.time(), "s"), quantity(place.x(), "m"),
                          quantity(place.y(), "m"), quantity(view.dt(), "s"),
                          quantity(view.lattice().step_limit, "s")),
              "take a smaller step or a smaller load");
}

[[noreturn]] void throw_at_fastest(const View& view) {
  const Grid& grid = view.lattice().grid;
  const State& state = view.state();
  int fastest_i = 0, fastest_j = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (state.v(i, j).squaredNorm() > state.v(fastest_i, fastest_j).squaredNorm())
        fastest_i = i, fastest_j = j;
  throw_diverged(view, fastest_i, fastest_j);
}

}  // namespace

double check_finite(const View& view) {
  // The largest value of a field, which is in single precision.
  constexpr auto max = static_cast<double>(std::numeric_limits<float>::max());
  const Grid& grid = view.lattice().grid;
  const State& state = view.state();
  const double u_most = max / grid.dx, v_most = max / (grid.dx / view.dt());
  double sum = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 moves = state.v(i, j);
      const double u = (state.origin + state.u(i, j)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
      const double v = moves.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
      if (!(u < u_most && v < v_most)) throw_diverged(view, i, j);
      sum += moves.squaredNorm();
    }
  return sum;
}

void Divergence::check(const View& view) {
  constexpr double beyond_reason = 1000.0;
  const double motion = check_finite(view);
  max_energy_ = std::max(max_energy_, std::abs(view.state().external_work));
  if (!(0.5 * motion <= beyond_reason * max_energy_)) throw_at_fastest(view);
}

}  // namespace hackle
