// SPDX-License-Identifier: MIT
#include "solver/instant.hpp"

namespace hackle {
namespace {

template <class Real>
void move_back(Values<Real>& places, const Values<Real>& velocities, double steps) {
  const auto share = static_cast<Real>(steps);
  for (std::size_t at = 0; at < places.size(); ++at) places[at] -= share * velocities[at];
}

State moved_back(State state, double steps) {
  std::visit(
      [steps](auto& motion) {
        move_back(motion.ux, motion.vx, steps);
        move_back(motion.uy, motion.vy, steps);
      },
      state.motion);
  for (std::vector<Disc>* bodies : {&state.discs, &state.rollers, &state.platens})
    for (Disc& body : *bodies) body.centre -= steps * body.velocity;
  return state;
}

}  // namespace

const State& Instant::seen(const State& state) const {
  if (behind_ == 0.0) return state;
  if (between_->bonds.empty()) *between_ = moved_back(state, behind_);
  return *between_;
}

}  // namespace hackle
