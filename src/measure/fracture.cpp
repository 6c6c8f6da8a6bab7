// SPDX-License-Identifier: MIT
#include "measure/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

// In horizons.
constexpr double innermost = 1.5, least_radius = 2.0, least_clear = 2.5, most_clear = 10.0;
constexpr double most_width = 2.0;
constexpr int default_rings = 4;

std::string text_of(const Vec2& place) {
  return fmt::format("({:.4g}, {:.4g}) mm", 1e3 * place.x(), 1e3 * place.y());
}

Error refusal(const FractureOptions& options, const std::string& what, const std::string& remedy) {
  return Error(ErrorKind::refused, fmt::format("{}: {}", options.who, what), remedy);
}

TipFrame frame_of(const View& view, const FractureOptions& options) {
  if (!options.tip) {
    const auto found = foremost_tip(view, options.along);
    if (!found)
      throw refusal(options, "there is no crack", "give its tip, or wait until something breaks");
    return options.ahead ? TipFrame{found->tip, options.ahead->stableNormalized()} : *found;
  }
  const Grid& grid = view.lattice().grid;
  const Vec2 place = grid.from_centre(*options.tip);
  if (std::abs(place.x()) > 0.5 * grid.nx || std::abs(place.y()) > 0.5 * grid.ny)
    throw refusal(options, fmt::format("the tip {} lies off the plate", text_of(*options.tip)),
                  "the origin is the lower left corner of the plate");
  if (options.ahead) return {*options.tip, options.ahead->stableNormalized()};
  const auto ahead = direction_at(view, *options.tip);
  if (!ahead)
    throw refusal(options,
                  fmt::format("no crack ends within three horizons of {}", text_of(*options.tip)),
                  "give the tip of a crack, or its direction");
  return {*options.tip, *ahead};
}

std::vector<ContourRing> default_rings_in(const Clearance& clear, double horizon,
                                          const FractureOptions& options, const Vec2& tip) {
  const double least = least_clear * horizon;
  if (clear.along < least)
    throw refusal(options,
                  fmt::format("only {} around the tip {} are clear of edges, holes and other "
                              "cracks, {:.2g} horizons",
                              quantity(clear.along, "m"), text_of(tip), clear.along / horizon),
                  fmt::format("a horizon of {} or less, or radii, each two horizons or more",
                              quantity(clear.along / least_clear, "m")));
  const double free = clear.all_round < least ? clear.along : clear.all_round;
  const double inner = innermost * horizon, room = std::min(free, most_clear * horizon) - inner;
  const double width = std::min(most_width * horizon, 0.6 * room);
  std::vector<ContourRing> rings;
  rings.reserve(default_rings);
  for (int k = 0; k < default_rings; ++k)
    rings.push_back({inner + 0.5 * width + (room - width) * k / (default_rings - 1), width});
  return rings;
}

std::vector<ContourRing> given_rings(double horizon, const FractureOptions& options) {
  std::vector<ContourRing> rings;
  for (const double radius : options.radii) {
    if (!(radius >= least_radius * horizon * (1.0 - 1e-9)))
      throw refusal(options, fmt::format("a radius of {} is too small", quantity(radius, "m")),
                    fmt::format("two horizons or more: {}", quantity(least_radius * horizon, "m")));
    rings.push_back({radius, std::min(most_width, 2.0 * (radius / horizon - innermost)) * horizon});
  }
  std::ranges::sort(rings, {}, &ContourRing::radius);
  return rings;
}

const Calibration& calibration_at(const Lattice& lattice, const Vec2& place) {
  const Grid& grid = lattice.grid;
  const Vec2 node = grid.from_centre(place) + 0.5 * Vec2(grid.nx - 1, grid.ny - 1);
  const int i = std::clamp(static_cast<int>(std::lround(node.x())), 0, grid.nx - 1);
  const int j = std::clamp(static_cast<int>(std::lround(node.y())), 0, grid.ny - 1);
  return lattice.is_void(i, j) ? lattice.calibration : lattice.material_at(i, j).calibration;
}

// Returns the mean over the rings that end within a distance; nothing without one.
std::optional<double> mean_within(double reach, const Fracture& found,
                                  double RingIntegrals::*value) {
  double sum = 0.0, count = 0.0;
  for (std::size_t k = 0; k < found.rings.size(); ++k) {
    if (found.rings[k].outer() > reach * (1.0 + 1e-9)) continue;
    sum += found.on_rings[k].*value;
    count += 1.0;
  }
  return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

std::optional<WilliamsFit> fitted(const View& view, const Fracture& found) {
  const double inner = found.rings.front().inner();
  const double outer = std::min(found.rings.back().outer(), found.clear.all_round);
  if (outer - inner < (1.0 - 1e-9) * view.numerics().horizon_or_default()) return std::nullopt;
  return fit_williams(view, found.frame, inner, outer, found.moduli);
}

}  // namespace

double Fracture::J() const {
  return mean_within(std::numeric_limits<double>::infinity(), *this, &RingIntegrals::J)
      .value_or(0.0);
}
std::optional<double> Fracture::K_I() const {
  return mean_within(clear.all_round, *this, &RingIntegrals::K_I);
}
std::optional<double> Fracture::K_II() const {
  return mean_within(clear.all_round, *this, &RingIntegrals::K_II);
}
double Fracture::K_J() const {
  return std::sqrt(moduli.stiffness() * std::max(J(), 0.0));
}
double Fracture::spread() const {
  const auto [min, max] = std::ranges::minmax(on_rings, {}, &RingIntegrals::J);
  return J() == 0.0 ? 0.0 : (max.J - min.J) / std::abs(J());
}

Fracture fracture(const View& view, const FractureOptions& options) {
  const Lattice& lattice = view.lattice();
  const double horizon = view.numerics().horizon_or_default();
  Fracture found;
  found.frame = frame_of(view, options);
  const auto clear = clearance(view, found.frame);
  if (!clear)
    throw refusal(options,
                  fmt::format("no crack is open a horizon behind {}", text_of(found.frame.tip)),
                  "give the tip of a straight crack, and its direction");
  found.clear = *clear;
  found.rings = options.radii.empty() ? default_rings_in(*clear, horizon, options, found.frame.tip)
                                      : given_rings(horizon, options);
  const Calibration& calibration = calibration_at(lattice, found.frame.tip);
  found.moduli = plane_moduli(calibration.moduli);
  found.G0 = fracture_energy(lattice.family, calibration.c, calibration.s0, lattice.grid.dx,
                             found.frame.normal());
  found.on_rings = ring_integrals(view, found.frame, found.rings, found.moduli);
  found.williams = fitted(view, found);
  return found;
}

std::optional<Fracture> fracture_if_any(const View& view, const FractureOptions& options) {
  try {
    return fracture(view, options);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::refused) throw;
    return std::nullopt;
  }
}

}  // namespace hackle
