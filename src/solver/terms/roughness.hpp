// SPDX-License-Identifier: MIT
// What resists two bodies that press each other (src/solver/README.md 7.8).
#pragma once

#include "scene/vec2.hpp"

namespace hackle {

// The share of its sliding velocity that friction against a rigid body may take from a node in a
// step. Two bodies at a node take half at most, which the limit of the step leaves room for
// (src/lattice/README.md 4.7).
inline constexpr double hold_of_body = 0.25;

struct Roughness {
  double friction = 0.0;     // coefficient of Coulomb
  double restitution = 1.0;  // speed after a rebound over that before

  bool is_smooth() const { return friction <= 0.0 && restitution >= 1.0; }
};

// Returns the loss of a contact: what is to be added to `force`, by which one body pushes the
// other. `velocity` is that of the other relative to the first. Where they part, restitution^2 of
// the force is left: a contact gives back that share of the energy that it took. Friction acts
// against the velocity across the force, with its coefficient times what is left of the force, but
// with at most `hold` times that velocity: what sticks creeps instead of trembling.
//
// `velocity` is in dx per step, forces and `hold` in multiples of mass times dx per step^2.
Vec2 loss_of(const Roughness& roughness, const Vec2& force, const Vec2& velocity, double hold);

}  // namespace hackle
