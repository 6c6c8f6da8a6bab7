// SPDX-License-Identifier: MIT
#include "lattice/numerics.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/units.hpp"
#include "lattice/calibration.hpp"
#include "lattice/node_layout.hpp"
#include "lattice/symbol.hpp"

namespace hackle {
namespace {

Family family_of(const Numerics& numerics) {
  return Family(numerics.m(), numerics.quadrature, numerics.micromodulus);
}

// Bytes per node: u, the next u and v; the words of bond bits, which lattice and state both hold, and
// a no-fail zone once more; the number of bonds; with a history three values for thresholds.
double bytes_per_node(const Plate& plate, const Numerics& numerics) {
  const double real = numerics.precision == Precision::f32 ? 4.0 : 8.0;
  const double words = std::ceil(1.7 * numerics.m() * numerics.m() / 32.0);
  const double values = plate.material.alpha > 0.0 ? 10.0 : 6.0;
  return real * values + 4.0 * words * (plate.no_fail.empty() ? 2.0 : 3.0) + 3.0;
}

double nodes(const Plate& plate, const Numerics& numerics) {
  return std::round(plate.width / numerics.spacing) * std::round(plate.height / numerics.spacing);
}

void check_memory(const Plate& plate, const Numerics& numerics, std::uint64_t memory,
                  Problems& problems) {
  const double needed = memory_needed(plate, numerics);
  const double count = nodes(plate, numerics);
  const double side = std::max(plate.width, plate.height) / numerics.spacing;
  const bool too_long = side > std::numeric_limits<int>::max() / 4.0;
  if (needed <= static_cast<double>(memory) && !too_long) return;
  problems.add(
      fmt::format("simulate: {:.3g} nodes need {} of memory, {} are free", count,
                  quantity(needed, "B"), quantity(static_cast<double>(memory), "B")),
      fmt::format(
          "a spacing of {} would fit",
          quantity(numerics.spacing * std::sqrt(1.2 * needed / static_cast<double>(memory)), "m")));
}

void check_step(const Plate& plate, const Numerics& numerics, Problems& problems) {
  if (!numerics.step || numerics.force_step) return;
  const Family family = family_of(numerics);
  const Calibration calibration =
      calibrate(family, plate.material, numerics.spacing, numerics.constants, plate.plane);
  const double limit = step_limit(family, calibration.c, plate.material.rho, numerics.spacing);
  if (*numerics.step <= limit) return;
  problems.add(fmt::format("simulate: step is {}, above the stability limit of {}",
                           quantity(*numerics.step, "s"), quantity(limit, "s")),
               "take a smaller step, or leave it out; force_step = true to see it blow up");
}

// Choices that do not go together.
void check_choices(const Plate& plate, const Numerics& numerics, Problems& problems) {
  if (!(numerics.fidelity >= 0.0 && numerics.fidelity <= 1.0))
    problems.add(
        fmt::format("simulate: fidelity is {}, it must lie between 0 and 1", numerics.fidelity));
  if (numerics.fidelity > 0.0 && plate.material.alpha > 0.0)
    problems.add("simulate: fidelity cannot go with alpha, whose history needs every bond",
                 "leave out fidelity, or take a material without alpha");
  const bool plain =
      plate.plane == Plane::stress && numerics.micromodulus == Micromodulus::constant;
  if (numerics.constants == Constants::paper && !plain)
    problems.add(
        "simulate: constants = \"paper\" are for plane stress and a constant micromodulus",
        "take constants = \"lattice\"");
}

// Of the horizon, in spacings; true when a lattice can be made.
bool check_horizon(const Numerics& numerics, Problems& problems) {
  const double m = numerics.m();
  const std::string spacing = quantity(numerics.spacing, "m");
  const std::string horizon = quantity(numerics.horizon_or_default(), "m");
  if (!(m >= least_m * (1.0 - 1e-9))) {
    problems.add(
        fmt::format("simulate: horizon {} is under {:g} spacings of {}", horizon, least_m, spacing),
        fmt::format("4 spacings, {}, are usual", quantity(4.0 * numerics.spacing, "m")));
    return false;
  }
  if (m <= most_m * (1.0 + 1e-9) && family_of(numerics).reach() <= NodeLayout::group) return true;
  problems.add(
      fmt::format("simulate: horizon {} is over {:g} spacings of {}", horizon,
                  m <= most_m * (1.0 + 1e-9) ? most_m - 0.5 : most_m, spacing),
      "take a coarser spacing or a shorter horizon");
  return false;
}

}  // namespace

double memory_needed(const Plate& plate, const Numerics& numerics) {
  return nodes(plate, numerics) * bytes_per_node(plate, numerics);
}

void check(const Plate& plate, const Numerics& numerics, std::uint64_t memory, Problems& problems) {
  const double least_side = std::min(plate.width, plate.height);
  if (!(numerics.spacing > 0.0) || !std::isfinite(numerics.spacing)) {
    problems.add(fmt::format("simulate: spacing is {} m, it must be above 0 m", numerics.spacing));
    return;
  }
  const std::string spacing = quantity(numerics.spacing, "m");
  if (numerics.spacing > least_side)
    problems.add(fmt::format("simulate: spacing {} is larger than the plate ({} x {})", spacing,
                             quantity(plate.width, "m"), quantity(plate.height, "m")),
                 "a tenth of the shorter side, or less, gives a lattice");
  check_choices(plate, numerics, problems);
  const bool has_family = check_horizon(numerics, problems);
  if (numerics.step && !(*numerics.step > 0.0 && std::isfinite(*numerics.step)))
    problems.add(fmt::format("simulate: step is {} s, it must be above 0 s", *numerics.step));
  if (!has_family) return;
  check_memory(plate, numerics, memory, problems);
  if (problems.empty()) check_step(plate, numerics, problems);
}

}  // namespace hackle
