// SPDX-License-Identifier: MIT
#include "solver/f32_range.hpp"

#include <algorithm>
#include <limits>

#include "lattice/lattice.hpp"

namespace hackle {
namespace {

// Calls work(i, j) for every node that is not void.
template <class Work>
void for_solid(const State& state, const std::vector<std::uint8_t>& material, const Work& work) {
  std::size_t node = 0;
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i, ++node)
      if (material.empty() || material[node] != Lattice::void_node) work(i, j);
}

}  // namespace

Spread spread_of(const State& state, const std::vector<std::uint8_t>& material) {
  Vec2 min = Vec2::Constant(std::numeric_limits<double>::infinity()), max = -min;
  for_solid(state, material, [&](int i, int j) {
    const Vec2 u = state.u(i, j);
    min = min.cwiseMin(u);
    max = max.cwiseMax(u);
  });
  return {0.5 * (max + min), 0.5 * (max - min)};
}

bool take_out_drift(State& state, const std::vector<std::uint8_t>& material) {
  // Rounded to f32, so that the origin is exactly what is subtracted.
  const Vec2 middle = spread_of(state, material).middle.cast<float>().cast<double>();
  if (!(middle.cwiseAbs().maxCoeff() > max_drift)) return false;
  for_solid(state, material, [&](int i, int j) { state.set_u(i, j, state.u(i, j) - middle); });
  state.origin += middle;
  return true;
}

bool is_too_wide_for_f32(const State& state, double s0, const std::vector<std::uint8_t>& material) {
  constexpr double rounding = 0.5 * std::numeric_limits<float>::epsilon();
  return spread_of(state, material).half.maxCoeff() * rounding > max_rounding * s0;
}

}  // namespace hackle
