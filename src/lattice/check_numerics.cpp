// SPDX-License-Identifier: MIT
#include "lattice/check_numerics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/units.hpp"
#include "lattice/calibration.hpp"
#include "lattice/needs.hpp"
#include "lattice/surface.hpp"
#include "lattice/symbol.hpp"
#include "lattice/touching.hpp"
#include "scene/check_members.hpp"

namespace hackle {
namespace {

Family family_of(const Numerics& numerics) {
  return Family(numerics.m(), numerics.quadrature, numerics.micromodulus);
}

// The number of columns and rows, unlimited because a spacing may be absurd.
struct Extent {
  double nx, ny;
  double nodes() const { return nx * ny; }
};

Extent extent(const Plate& plate, const Numerics& numerics) {
  return {std::round(plate.width / numerics.spacing), std::round(plate.height / numerics.spacing)};
}

void check_memory(const Plate& plate, const Numerics& numerics, std::uint64_t memory,
                  Problems& problems) {
  const double needed = memory_of(plate, numerics).all(), free = static_cast<double>(memory);
  const Extent size = extent(plate, numerics);
  if (needed <= free && std::max(size.nx, size.ny) <= max_columns) return;
  problems.add(fmt::format("simulate: {:.3g} nodes need {} of memory, {} are free", size.nodes(),
                           quantity(needed, "B"), quantity(free, "B")),
               fmt::format("a spacing of {} would fit",
                           quantity(numerics.spacing * std::sqrt(1.2 * needed / free), "m")));
}

// Returns whether the constants are defined for this plate and micromodulus.
bool constants_apply(const Plate& plate, const Numerics& numerics) {
  const bool plain =
      plate.plane == Plane::stress && numerics.micromodulus == Micromodulus::constant;
  return plain || numerics.constants != Constants::paper;
}

double max_alpha(const Plate& plate) {
  double max = plate.material.alpha;
  for (const Inclusion& inclusion : plate.inclusions) max = std::max(max, inclusion.material.alpha);
  return max;
}

// Checks for incompatible choices.
void check_choices(const Plate& plate, const Numerics& numerics, Problems& problems) {
  const double alpha = max_alpha(plate);
  if (numerics.fidelity > 0.0 && alpha > 0.0)
    problems.add(
        fmt::format(
            "simulate: fidelity is {} and the material's alpha {}: the history of the least "
            "stretch needs every bond",
            shortest(numerics.fidelity), shortest(alpha)),
        "leave out fidelity, or take a material without alpha");
  if (!constants_apply(plate, numerics))
    problems.add("simulate: constants = \"paper\" are for plane stress and a constant micromodulus",
                 "take constants = \"lattice\"");
}

bool is_positive(double value) {
  return value > 0.0 && std::isfinite(value);
}

// Checks the spacing; returns true if it makes a lattice.
bool check_spacing(const Plate& plate, const Numerics& numerics, Problems& problems) {
  if (!is_positive(numerics.spacing)) return false;
  if (numerics.spacing > std::min(plate.width, plate.height))
    problems.add(fmt::format("simulate: spacing {} is larger than the plate ({} x {})",
                             quantity(numerics.spacing, "m"), quantity(plate.width, "m"),
                             quantity(plate.height, "m")),
                 "a tenth of the shorter side, or less, gives a lattice");
  return true;
}

// Checks the horizon, in spacings; returns true if it makes a family.
bool check_horizon(const Numerics& numerics, Problems& problems) {
  constexpr double slack = 1e-9;
  if (!is_positive(numerics.horizon_or_default())) return false;
  const double m = numerics.m();
  const std::string spacing = quantity(numerics.spacing, "m");
  const std::string horizon = quantity(numerics.horizon_or_default(), "m");
  if (!(m >= min_m * (1.0 - slack)))
    problems.add(
        fmt::format("simulate: horizon {} is under {:g} spacings of {}", horizon, min_m, spacing),
        fmt::format("4 spacings, {}, are usual", quantity(4.0 * numerics.spacing, "m")));
  else if (m > max_m * (1.0 + slack))
    problems.add(
        fmt::format("simulate: horizon {} is over {:g} spacings of {}", horizon, max_m, spacing),
        "take a coarser spacing or a shorter horizon");
  else
    return true;
  return false;
}

// Returns false if a constant has overflowed, or lost bits near 0.
bool can_be_computed_with(const Calibration& found) {
  return std::isnormal(found.moduli.E) && std::isnormal(found.s0) && std::isnormal(found.G0);
}

// Requires a family. Returns nothing if the material or the constants give no stiffness, which is
// reported elsewhere, or if the numbers overflow, which is reported here.
std::optional<double> micromodulus_of(const Material& material, const Plate& plate,
                                      const Numerics& numerics, const Family& family,
                                      Problems& problems) {
  Problems of_material;
  check(material, of_material);
  if (!of_material.empty() || !constants_apply(plate, numerics)) return std::nullopt;
  const double dx = numerics.spacing;
  const Calibration found = calibrate(family, material, dx, numerics.constants, plate.plane);
  if (can_be_computed_with(found) && std::isnormal(found.c * dx / material.rho)) return found.c;
  problems.add(
      fmt::format("simulate: E {}, rho {} kg/m3, {} and spacing {} are beyond what numbers "
                  "can express together",
                  quantity(material.E, "Pa"), material.rho,
                  material.s0 > 0.0 ? fmt::format("s0 {:g}", material.s0)
                                    : "G0 " + quantity(material.G0, "J/m2"),
                  quantity(dx, "m")),
      "take values nearer to a real plate's");
  return std::nullopt;
}

// A body that crosses much of a spacing per step is not resolved, even if the step is stable.
void check_bodies(const Plate& plate, const Numerics& numerics, Problems& problems) {
  const auto [longest, who] = longest_step_of_bodies(plate, numerics.spacing);
  if (*numerics.step <= longest * (1.0 + 1e-9)) return;
  problems.add(fmt::format("{}: in a step of {} it crosses {:.2g} spacings, {:g} are the most", who,
                           quantity(*numerics.step, "s"), max_crossed * *numerics.step / longest,
                           max_crossed),
               fmt::format("take a step of {} or less, or leave it out", quantity(longest, "s")));
}

// The limit combines the stiffest and the lightest material.
void check_against_limit(const Plate& plate, const Numerics& numerics, Problems& problems) {
  const Family family = family_of(numerics);
  const auto own = micromodulus_of(plate.material, plate, numerics, family, problems);
  double c = own.value_or(0.0), rho = plate.material.rho;
  bool known = own.has_value();
  for (const Inclusion& inclusion : plate.inclusions) {
    const auto other = micromodulus_of(inclusion.material, plate, numerics, family, problems);
    known = known && other;
    c = std::max(c, other.value_or(0.0));
    rho = std::min(rho, inclusion.material.rho);
  }
  if (!known || !numerics.step || numerics.force_step) return;
  const double limit = step_limit(family, stiffening(numerics.surface) * c, rho, numerics.spacing,
                                  touching_of(plate, numerics.spacing));
  if (*numerics.step <= limit) return;
  problems.add(fmt::format("simulate: step is {}, above the stability limit of {}",
                           quantity(*numerics.step, "s"), quantity(limit, "s")),
               "take a smaller step, or leave it out; force_step = true to see it blow up");
}

void check_step(const Plate& plate, const Numerics& numerics, bool has_family, Problems& problems) {
  if (numerics.step && !is_positive(*numerics.step)) return;
  if (has_family) check_against_limit(plate, numerics, problems);
  if (numerics.step && numerics.spacing > 0.0 && !numerics.force_step)
    check_bodies(plate, numerics, problems);
}

}  // namespace

void check(const Plate& plate, const Numerics& numerics, std::uint64_t memory, Problems& problems) {
  check_members(numerics, "simulate", problems);
  const bool has_family =
      check_spacing(plate, numerics, problems) && check_horizon(numerics, problems);
  check_choices(plate, numerics, problems);
  check_step(plate, numerics, has_family, problems);
  if (has_family) check_memory(plate, numerics, memory, problems);
}

}  // namespace hackle
