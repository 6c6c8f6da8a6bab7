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

namespace {

// The largest values of a field, which is in single precision, in lattice units.
struct Limits {
  explicit Limits(const View& view)
      : u(max / view.lattice().grid.dx), v(max / (view.lattice().grid.dx / view.dt())) {}
  static constexpr auto max = static_cast<double>(std::numeric_limits<float>::max());
  double u, v;

  bool hold(const State& state, int i, int j) const {
    const Vec2 place = state.origin + state.u(i, j), moves = state.v(i, j);
    return place.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() < u &&
           moves.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() < v;
  }
};

}  // namespace

void check_finite(const View& view) {
  const Grid& grid = view.lattice().grid;
  const Limits limits(view);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (!limits.hold(view.state(), i, j)) throw_diverged(view, i, j);
}

bool Divergence::is_seen(const View& view, const Slab& slab) {
  constexpr double beyond_reason = 1000.0;
  const Grid& grid = view.lattice().grid;
  const State& state = view.state();
  const Limits limits(view);
  bool finite = true;
  RowSum motion(slab);
  for (int j = slab.begin(); j < slab.end(grid.ny) && finite; ++j)
    for (int i = 0; i < grid.nx && finite; ++i) {
      finite = limits.hold(state, i, j);
      motion.add(j, state.v(i, j).squaredNorm());
    }
  const double sum = motion.value();
  max_energy_ = std::max(max_energy_, std::abs(state.external_work));
  const bool seen = !finite || !(0.5 * sum <= beyond_reason * max_energy_);
  return slab.is_whole() ? seen : slab.ranks->any(seen ? 1 : 0) != 0;
}

void Divergence::tell(const View& view) {
  check_finite(view);
  throw_at_fastest(view);
}

}  // namespace hackle
