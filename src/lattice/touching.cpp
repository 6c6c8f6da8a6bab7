// SPDX-License-Identifier: MIT
#include "lattice/touching.hpp"

#include <algorithm>
#include <limits>

namespace hackle {

Touching touching_of(const Plate& plate, double dx) {
  double recoil = 0.0;
  for (const Impactor& disc : plate.loads.impactors)
    recoil =
        std::max(recoil, std::min(1.0, 2.0 * disc.radius * dx * plate.material.rho / disc.mass));
  const double discs = std::min(2.0, static_cast<double>(plate.loads.impactors.size()));
  return {plate.contact ? faces_bear : 1.0,
          4.0 * contact_stiffness(plate) +
              discs * (1.0 + recoil) * plate.contact.value_or(Contact{}).stiffness};
}

double longest_step_of_impact(const Plate& plate, double dx) {
  Vec2 start{0, 0};
  for (const Start& motion : plate.starts)
    if (motion.velocity.is_constant()) start += motion.velocity.constant();
  double longest = std::numeric_limits<double>::infinity();
  for (const Impactor& disc : plate.loads.impactors) {
    const double speed = std::max(disc.velocity.norm(), (disc.velocity - start).norm());
    if (speed > 0.0) longest = std::min(longest, most_crossed * dx / speed);
  }
  return longest;
}

}  // namespace hackle
