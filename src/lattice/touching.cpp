// SPDX-License-Identifier: MIT
#include "lattice/touching.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <type_traits>
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

// Returns the share of the acceleration of the nodes that a body pushes which it has itself.
double recoil_of(double breadth, double mass, const Plate& plate, double dx) {
  return std::min(1.0, breadth * dx * plate.material.rho / mass);
}

// Returns what rollers and platens add at a node, in stiffnesses of a contact: any two may push it
// at a time, and those that are led by a force recoil.
double led_at_a_node(const Plate& plate, double dx) {
  const Loads& loads = plate.loads;
  double recoil = 0.0;
  for_each_guided(loads, [&](const auto& body) {
    if (body.guided.guide == Guide::force)
      recoil = std::max(
          recoil, recoil_of(breadth_of(body), mass_of(body.guided, area_of(body)), plate, dx));
  });
  const auto bodies = std::min<std::size_t>(2, loads.rollers.size() + loads.platens.size());
  return static_cast<double>(bodies) * (1.0 + recoil);
}

bool rubs(const Plate& plate) {
  const auto rough = [](const auto& body) { return body.friction > 0.0; };
  const Loads& loads = plate.loads;
  bool guided = false;
  for_each_guided(loads, [&](const auto& body) { guided = guided || rough(body.guided); });
  return guided || (plate.contact && rough(*plate.contact)) ||
         std::ranges::any_of(loads.impactors, rough);
}

}  // namespace

Touching touching_of(const Plate& plate, double dx) {
  double recoil = 0.0;
  for (const Impactor& disc : plate.loads.impactors)
    recoil = std::max(recoil, recoil_of(2.0 * disc.radius, disc.mass, plate, dx));
  const double discs = discs_at_a_node(plate.loads.impactors, dx);
  return {plate.contact ? faces_bear : 1.0,
          4.0 * contact_stiffness(plate) + (discs * (1.0 + recoil) + led_at_a_node(plate, dx)) *
                                               plate.contact.value_or(Contact{}).stiffness,
          spring_stiffness(plate.loads),
          (plate.loads.absorbers.empty() ? 1.0 : left_by_absorber) *
              (rubs(plate) ? left_by_friction : 1.0),
          plate.loads.stiffness_damping};
}

namespace {

// Returns 0 where it is not known beforehand: by a force, or by a function of time. A jump is no
// speed: it is refused where the body moves.
double speed_of(const Guided& guided) {
  if (guided.guide == Guide::force) return 0.0;
  const double factor =
      guided.guide == Guide::velocity ? guided.amplitude.largest() : guided.amplitude.steepest();
  return std::isfinite(factor) ? factor * guided.value.norm() : 0.0;
}

}  // namespace

StepOfBodies longest_step_of_bodies(const Plate& plate, double dx) {
  Vec2 start{0, 0};
  for (const InitialCondition& motion : plate.initial_conditions)
    if (motion.velocity.is_constant()) start += motion.velocity.constant();
  StepOfBodies found;
  const auto take = [&](double speed, std::string_view who) {
    const double longest = speed > 0.0 ? max_crossed * dx / speed : found.longest;
    if (longest < found.longest) found = {longest, who};
  };
  for (const Impactor& disc : plate.loads.impactors)
    take(std::max(disc.velocity.norm(), (disc.velocity - start).norm()), "impactor");
  for_each_guided(plate.loads, [&](const auto& body) {
    take(speed_of(body.guided), description_of<std::remove_cvref_t<decltype(body)>>.noun);
  });
  return found;
}

}  // namespace hackle
