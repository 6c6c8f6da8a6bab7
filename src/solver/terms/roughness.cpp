// SPDX-License-Identifier: MIT
#include "solver/terms/roughness.hpp"

#include <algorithm>

namespace hackle {

Vec2 loss_of(const Roughness& roughness, const Vec2& force, const Vec2& velocity, double hold) {
  const double size = force.norm();
  if (roughness.is_smooth() || !(size > 0.0)) return {0, 0};
  const Vec2 outward = force / size;
  const double apart = velocity.dot(outward), e = roughness.restitution;
  const double left = apart > 0.0 ? e * e : 1.0;
  const Vec2 slip = velocity - apart * outward;
  const double speed = slip.norm();
  Vec2 loss = (left - 1.0) * force;
  if (!(speed > 0.0)) return loss;
  return loss - std::min(roughness.friction * left * size / speed, hold) * slip;
}

}  // namespace hackle
