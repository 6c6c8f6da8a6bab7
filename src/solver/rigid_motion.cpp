// SPDX-License-Identifier: MIT
#include "solver/rigid_motion.hpp"

#include <algorithm>
#include <limits>

namespace hackle {
namespace {

template <class Real>
Values<double> widened(const Values<Real>& values) {
  return {values.begin(), values.end()};
}

}  // namespace

Spread spread_of(const State& state) {
  Vec2 least = state.u(0, 0), most = least;
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i) {
      const Vec2 u = state.u(i, j);
      least = least.cwiseMin(u);
      most = most.cwiseMax(u);
    }
  return {0.5 * (most + least), 0.5 * (most - least)};
}

bool take_out_drift(State& state) {
  // Rounded to f32, so that the origin is what is really subtracted.
  const Vec2 middle = spread_of(state).middle.cast<float>().cast<double>();
  if (!(middle.cwiseAbs().maxCoeff() > most_drift)) return false;
  for (int j = 0; j < state.layout.ny; ++j)
    for (int i = 0; i < state.layout.nx; ++i) state.set_u(i, j, state.u(i, j) - middle);
  state.origin += middle;
  return true;
}

bool is_too_wide_for_f32(const State& state, double s0) {
  constexpr double rounding = 0.5 * std::numeric_limits<float>::epsilon();
  return spread_of(state).half.maxCoeff() * rounding > most_rounding * s0;
}

State in_f64(const State& state) {
  State wide = state;
  if (const auto* motion = std::get_if<Motion<float>>(&state.motion))
    wide.motion = Motion<double>{widened(motion->ux), widened(motion->uy), widened(motion->vx),
                                 widened(motion->vy), widened(motion->threshold)};
  return wide;
}

}  // namespace hackle
