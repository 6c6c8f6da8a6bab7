// SPDX-License-Identifier: MIT
#include "scene/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

constexpr int places = 21;       // along x and y
constexpr int moments = 101;     // of the duration
constexpr int few_moments = 21;  // where each takes all places

double size_of(double value) {
  return std::abs(value);
}
double size_of(const Vec2& value) {
  return value.norm();
}

// Samples quantities for their largest magnitude.
struct Sampler {
  const Plate& plate;
  double begin, end;
  bool sampled = false;

  double largest(const Amplitude& amplitude) {
    sampled = sampled || amplitude.is_function();
    double max = 0.0;
    for (int k = 0; k < moments; ++k)
      max = std::max(max, std::abs(amplitude.at(begin + (end - begin) * k / (moments - 1))));
    for (const Vec2& point : amplitude.points())
      if (point.x() >= begin && point.x() <= end) max = std::max(max, std::abs(point.y()));
    return max;
  }

  template <class T>
  double largest(const FieldOfPlace<T>& field) {
    if (field.is_constant()) return size_of(field.constant());
    sampled = true;
    double max = 0.0;
    const int times = field.varies_in_time() ? few_moments : 1;
    for (int k = 0; k < times; ++k)
      max = std::max(max, largest(field, begin + (end - begin) * k / (few_moments - 1)));
    return max;
  }

  template <class T>
  double largest(const FieldOfPlace<T>& field, double t) const {
    double max = 0.0;
    for (int j = 0; j < places; ++j)
      for (int i = 0; i < places; ++i)
        max = std::max(
            max, size_of(field.at({plate.width * i / (places - 1), plate.height * j / (places - 1)},
                                  t)));
    return max;
  }
};

// Stress caused by moving the rim: at once by the wave, sigma = rho c v; later by the strain.
struct Stiffness {
  explicit Stiffness(const Plate& plate)
      : E(plate.material.E),
        impedance(std::sqrt(plate.material.E * plate.material.rho)),
        span(std::min(plate.width, plate.height)) {}
  double of_displacement(double u) const { return E * u / span; }
  double of_velocity(double v) const { return impedance * v; }

  double E, impedance, span;
};

// A prescribed velocity sends out waves where it acts; if slow, without waves, it only strains the
// plate.
double stress_of_motion(double value, bool is_displacement, const Episode& episode,
                        Sampler& sampler) {
  const Stiffness stiffness(sampler.plate);
  if (is_displacement) return stiffness.of_displacement(value);
  const double led = stiffness.of_displacement(value * (episode.end - episode.since));
  return episode.slow ? led : std::max(stiffness.of_velocity(value), led);
}

double stress_of(const Support& support, const Episode& episode, Sampler& sampler) {
  const double value = sampler.largest(support.value) * sampler.largest(support.amplitude);
  return stress_of_motion(value, support.kind == Support::Kind::displacement, episode, sampler);
}

// Of a roller or platen that strikes at its speed, or presses as far as it goes, or by its force.
double stress_of(const Guided& guided, const Episode& episode, Sampler& sampler) {
  const double value = guided.value.norm() * sampler.largest(guided.amplitude);
  if (guided.guide == Guide::force)
    return value / std::min(sampler.plate.width, sampler.plate.height);
  return stress_of_motion(value, guided.guide == Guide::displacement, episode, sampler);
}

// Returns the stress of the material that would expand most, if it were held.
double stress_of_heat(const Plate& plate, double change) {
  double max = plate.material.E * plate.material.alphaT;
  for (const Inclusion& inclusion : plate.inclusions)
    max = std::max(max, inclusion.material.E * inclusion.material.alphaT);
  return max * change;
}

double stress_of(const Loads& loads, const Episode& episode, Sampler& sampler) {
  const Plate& plate = sampler.plate;
  double sum = 0.0;
  for (const Traction& load : loads.tractions)
    sum = std::max(sum, sampler.largest(load.stress) * sampler.largest(load.amplitude));
  for (const Pressure& load : loads.pressures)
    sum += std::abs(load.pressure) * sampler.largest(load.amplitude);
  for (const BodyForce& load : loads.body_forces)
    sum += sampler.largest(load.force) * sampler.largest(load.amplitude) *
           std::max(plate.width, plate.height);
  for (const Support& support : loads.supports) sum += stress_of(support, episode, sampler);
  for (const ThermalLoad& load : loads.thermal_loads)
    sum += stress_of_heat(plate, sampler.largest(load.change) * sampler.largest(load.amplitude));
  for (const Impactor& impactor : loads.impactors)
    sum += Stiffness(plate).of_velocity(impactor.velocity.norm());
  for_each_guided(loads,
                  [&](const auto& body) { sum += stress_of(body.guided, episode, sampler); });
  return sum;
}

double stress_of(const std::vector<InitialCondition>& starts, Sampler& sampler) {
  const Stiffness stiffness(sampler.plate);
  double sum = 0.0;
  for (const InitialCondition& start : starts)
    sum += stiffness.of_velocity(sampler.largest(start.velocity)) +
           stiffness.of_displacement(sampler.largest(start.displacement));
  return sum;
}

double largest_flaw(const Plate& plate) {
  double max = 0.0;
  const auto take = [&](const Vec2& min, const Vec2& greatest, double share) {
    max = std::max(max, share * (greatest - min).maxCoeff());
  };
  for (const Crack& crack : plate.cracks) {
    Vec2 min = crack.points.front(), greatest = min;
    for (const Vec2& point : crack.points) {
      min = min.cwiseMin(point);
      greatest = greatest.cwiseMax(point);
    }
    take(min, greatest, 1.0);
  }
  for (const Cutout& cutout : plate.cutouts) {
    const Box box = bounds(cutout.shape);
    take(box.min, box.max, 0.5);
  }
  return max;
}

// Follows from G0, or from s0 as the energy that stretches one horizon to s0.
double toughness_of(const Material& material, double min_flaw) {
  return material.s0 > 0.0 ? material.E * material.s0 * material.s0 * min_flaw : material.G0;
}

}  // namespace

Forecast forecast(const Plate& plate, const Episode& episode, double min_flaw) {
  Forecast found;
  Sampler sampler{plate, episode.begin, episode.end};
  double stress = stress_of(plate.loads, episode, sampler);
  if (episode.begin == 0.0) stress += stress_of(plate.initial_conditions, sampler);
  found.stress = std::max((episode.slow ? 1.0 : overshoot) * stress, episode.stored);
  found.sampled = sampler.sampled;
  found.flaw = std::max(largest_flaw(plate), min_flaw);
  found.release_rate =
      found.stress * found.stress * std::numbers::pi * found.flaw / plate.material.E;
  found.toughness = toughness_of(plate.material, min_flaw);
  for (const Inclusion& inclusion : plate.inclusions)
    found.toughness = std::min(found.toughness, toughness_of(inclusion.material, min_flaw));
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
    return forecast.sampled
               ? "unknown: its loads are 0 wherever and whenever their functions were asked"
               : "nothing loads it: nothing can break";
  return fmt::format("a flaw of {} under up to {} releases up to {}, G0 is {}: {}",
                     quantity(forecast.flaw, "m"), quantity(forecast.stress, "Pa"),
                     quantity(forecast.release_rate, "J/m2"), quantity(forecast.toughness, "J/m2"),
                     words[static_cast<std::size_t>(forecast.verdict())]);
}

}  // namespace hackle
