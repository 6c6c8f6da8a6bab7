// SPDX-License-Identifier: MIT
#include "scene/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

constexpr int places = 21;    // along x and y
constexpr int moments = 101;  // of the duration
constexpr double overshoot = 2.0;

double largest(const Course& course, double duration) {
  double most = 0.0;
  for (int k = 0; k < moments; ++k)
    most = std::max(most, std::abs(course.at(duration * k / (moments - 1))));
  for (const Vec2& point : course.points())
    if (point.x() <= duration) most = std::max(most, std::abs(point.y()));
  return most;
}

double size_of(double value) {
  return std::abs(value);
}
double size_of(const Vec2& value) {
  return value.norm();
}

template <class T>
double largest(const FieldOfPlace<T>& field, const Plate& plate) {
  if (field.is_constant()) return size_of(field.constant());
  double most = 0.0;
  for (int j = 0; j < places; ++j)
    for (int i = 0; i < places; ++i)
      most = std::max(
          most,
          size_of(field.at({plate.width * i / (places - 1), plate.height * j / (places - 1)})));
  return most;
}

// What a motion of the rim does: at once, as a wave of sigma = rho c v, and in time, as a strain.
struct Stiffness {
  explicit Stiffness(const Plate& plate)
      : E(plate.material.E),
        impedance(std::sqrt(plate.material.E * plate.material.rho)),
        span(std::min(plate.width, plate.height)) {}
  double of_displacement(double u) const { return E * u / span; }
  double of_velocity(double v) const { return impedance * v; }

  double E, impedance, span;
};

double stress_of(const Support& support, const Plate& plate, double duration) {
  const Stiffness stiffness(plate);
  const double value = largest(support.value, plate) * largest(support.course, duration);
  if (support.kind == Support::Kind::displacement) return stiffness.of_displacement(value);
  return std::max(stiffness.of_velocity(value), stiffness.of_displacement(value * duration));
}

double stress_of(const Loads& loads, const Plate& plate, double duration) {
  const Stiffness stiffness(plate);
  double sum = 0.0;
  for (const Traction& load : loads.tractions)
    sum = std::max(sum, largest(load.stress, plate) * largest(load.course, duration));
  for (const Pressure& load : loads.pressures)
    sum += std::abs(load.pressure) * largest(load.course, duration);
  for (const BodyForce& load : loads.body_forces)
    sum += largest(load.force, plate) * largest(load.course, duration) *
           std::max(plate.width, plate.height);
  for (const Support& support : loads.supports) sum += stress_of(support, plate, duration);
  for (const Heating& load : loads.heatings)
    sum += stiffness.E * plate.material.alphaT * largest(load.change, plate) *
           largest(load.course, duration);
  for (const Impactor& impactor : loads.impactors)
    sum += stiffness.of_velocity(impactor.velocity.norm());
  return sum;
}

double stress_of(const std::vector<Start>& starts, const Plate& plate) {
  const Stiffness stiffness(plate);
  double sum = 0.0;
  for (const Start& start : starts)
    sum += stiffness.of_velocity(largest(start.velocity, plate)) +
           stiffness.of_displacement(largest(start.displacement, plate));
  return sum;
}

double largest_flaw(const Plate& plate) {
  double most = 0.0;
  const auto take = [&](const Vec2& least, const Vec2& greatest, double share) {
    most = std::max(most, share * (greatest - least).maxCoeff());
  };
  for (const Crack& crack : plate.cracks) {
    Vec2 least = crack.points.front(), greatest = least;
    for (const Vec2& point : crack.points) {
      least = least.cwiseMin(point);
      greatest = greatest.cwiseMax(point);
    }
    take(least, greatest, 1.0);
  }
  for (const Cutout& cutout : plate.cutouts) {
    const Box box = bounds(cutout.shape);
    take(box.least, box.most, 0.5);
  }
  return most;
}

// From G0, or from s0 as the energy that stretches a horizon so far.
double toughness_of(const Material& material, double least_flaw) {
  return material.s0 > 0.0 ? material.E * material.s0 * material.s0 * least_flaw : material.G0;
}

}  // namespace

Forecast forecast(const Plate& plate, double duration, double least_flaw) {
  Forecast found;
  found.stress =
      overshoot * (stress_of(plate.loads, plate, duration) + stress_of(plate.starts, plate));
  found.flaw = std::max(largest_flaw(plate), least_flaw);
  found.release_rate =
      found.stress * found.stress * std::numbers::pi * found.flaw / plate.material.E;
  found.toughness = toughness_of(plate.material, least_flaw);
  for (const Inclusion& inclusion : plate.inclusions)
    found.toughness = std::min(found.toughness, toughness_of(inclusion.material, least_flaw));
  return found;
}

Forecast::Verdict Forecast::verdict() const {
  constexpr double doubt = 4.0;
  if (stress <= 0.0) return Verdict::nothing_loads_it;
  if (release_rate < toughness / doubt) return Verdict::nothing_breaks;
  return release_rate < toughness * doubt ? Verdict::may_break : Verdict::breaks;
}

std::string describe(const Forecast& forecast) {
  constexpr std::array words{"nothing can break", "nothing should break", "it may break",
                             "it should break"};
  if (forecast.verdict() == Forecast::Verdict::nothing_loads_it)
    return "nothing loads it: nothing can break";
  return fmt::format("a flaw of {} under up to {} releases up to {}, G0 is {}: {}",
                     quantity(forecast.flaw, "m"), quantity(forecast.stress, "Pa"),
                     quantity(forecast.release_rate, "J/m2"), quantity(forecast.toughness, "J/m2"),
                     words[static_cast<std::size_t>(forecast.verdict())]);
}

}  // namespace hackle
