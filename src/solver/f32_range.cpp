// SPDX-License-Identifier: MIT
#include "solver/f32_range.hpp"

#include <algorithm>
#include <limits>

#include "lattice/lattice.hpp"

namespace hackle {
namespace {

struct Bounds {
  Vec2 min = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 max = -min;
};

// Calls work(i, j) for every node of some rows that is not void.
template <class Work>
void for_solid(const State& state, const std::vector<std::uint8_t>& material, int begin, int end,
               const Work& work) {
  const Grid grid{state.layout.nx, state.layout.ny, 1.0, {0, 0}};
  for (int j = begin; j < end; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (material.empty() || material[grid.index(i, j)] != Lattice::void_node) work(i, j);
}

Bounds of_all_ranks(const Bounds& own, const Slab& slab) {
  if (slab.is_whole()) return own;
  Bounds all;
  const std::vector<double> values{own.min.x(), own.min.y(), own.max.x(), own.max.y()};
  const auto of_ranks = slab.ranks->gather(bytes_to_send(values)).as<double>();
  for (std::size_t k = 0; k < of_ranks.size(); k += 4) {
    all.min = all.min.cwiseMin(Vec2(of_ranks[k], of_ranks[k + 1]));
    all.max = all.max.cwiseMax(Vec2(of_ranks[k + 2], of_ranks[k + 3]));
  }
  return all;
}

bool is_too_wide(const Spread& spread, double s0) {
  constexpr double rounding = 0.5 * std::numeric_limits<float>::epsilon();
  return spread.half.maxCoeff() * rounding > max_rounding * s0;
}

// Rounded to f32, so that the origin is exactly what is subtracted.
Vec2 drift_of(const Spread& spread) {
  return spread.middle.cast<float>().cast<double>();
}

bool has_drifted(const Vec2& drift) {
  return drift.cwiseAbs().maxCoeff() > max_drift;
}

}  // namespace

Spread spread_of(const State& state, const std::vector<std::uint8_t>& material, const Slab& slab) {
  Bounds own;
  for_solid(state, material, slab.begin(), slab.end(state.layout.ny), [&](int i, int j) {
    const Vec2 u = state.u(i, j);
    own.min = own.min.cwiseMin(u);
    own.max = own.max.cwiseMax(u);
  });
  const Bounds all = of_all_ranks(own, slab);
  return {0.5 * (all.max + all.min), 0.5 * (all.max - all.min)};
}

Spread spread_of(const State& state, const std::vector<std::uint8_t>& material) {
  return spread_of(state, material, {});
}

bool is_to_be_moved(const Spread& spread, double s0) {
  return has_drifted(drift_of(spread)) || is_too_wide(spread, s0);
}

bool take_out_drift(State& state, const std::vector<std::uint8_t>& material) {
  const Vec2 drift = drift_of(spread_of(state, material));
  if (!has_drifted(drift)) return false;
  for_solid(state, material, 0, state.layout.ny,
            [&](int i, int j) { state.set_u(i, j, state.u(i, j) - drift); });
  state.origin += drift;
  return true;
}

bool is_too_wide_for_f32(const State& state, double s0, const std::vector<std::uint8_t>& material) {
  return is_too_wide(spread_of(state, material), s0);
}

}  // namespace hackle
