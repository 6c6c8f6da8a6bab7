// SPDX-License-Identifier: MIT
#include "lattice/touching.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

namespace hackle {
namespace {

// Returns the smallest distance of two discs that fly on straight paths.
double closest_distance(const Impactor& one, const Impactor& other) {
  const Vec2 apart = other.centre - one.centre, speed = other.velocity - one.velocity;
  const double square = speed.squaredNorm();
  const double when = square > 0.0 ? std::max(0.0, -apart.dot(speed) / square) : 0.0;
  return (apart + when * speed).norm();
}

// Returns how many discs may push one node at a time: those that come near each other, and any two,
// because the plate may throw them together.
double discs_at_a_node(const std::vector<Impactor>& discs, double dx) {
  std::ptrdiff_t max = std::min<std::ptrdiff_t>(2, std::ssize(discs));
  for (const Impactor& one : discs)
    max = std::max(max, std::ranges::count_if(discs, [&](const Impactor& other) {
                     return closest_distance(one, other) < one.radius + other.radius + 2.0 * dx;
                   }));
  return static_cast<double>(max);
}

// Returns how many rollers and platens may push one node at a time: any two.
double led_at_a_node(const Loads& loads) {
  return static_cast<double>(std::min<std::size_t>(2, loads.rollers.size() + loads.platens.size()));
}

bool rubs(const Plate& plate) {
  const auto rough = [](const auto& body) { return body.friction > 0.0; };
  const Loads& loads = plate.loads;
  return (plate.contact && rough(*plate.contact)) || std::ranges::any_of(loads.impactors, rough) ||
         std::ranges::any_of(loads.rollers, rough) || std::ranges::any_of(loads.platens, rough);
}

}  // namespace

Touching touching_of(const Plate& plate, double dx) {
  double recoil = 0.0;
  for (const Impactor& disc : plate.loads.impactors)
    recoil =
        std::max(recoil, std::min(1.0, 2.0 * disc.radius * dx * plate.material.rho / disc.mass));
  const double discs = discs_at_a_node(plate.loads.impactors, dx);
  return {plate.contact ? faces_bear : 1.0,
          4.0 * contact_stiffness(plate) + (discs * (1.0 + recoil) + led_at_a_node(plate.loads)) *
                                               plate.contact.value_or(Contact{}).stiffness,
          spring_stiffness(plate.loads),
          (plate.loads.absorbers.empty() ? 1.0 : left_by_absorber) *
              (rubs(plate) ? left_by_friction : 1.0),
          plate.loads.stiffness_damping};
}

double longest_step_of_impact(const Plate& plate, double dx) {
  Vec2 start{0, 0};
  for (const InitialCondition& motion : plate.initial_conditions)
    if (motion.velocity.is_constant()) start += motion.velocity.constant();
  double longest = std::numeric_limits<double>::infinity();
  for (const Impactor& disc : plate.loads.impactors) {
    const double speed = std::max(disc.velocity.norm(), (disc.velocity - start).norm());
    if (speed > 0.0) longest = std::min(longest, max_crossed * dx / speed);
  }
  return longest;
}

}  // namespace hackle
