// SPDX-License-Identifier: MIT
#include "solver/default_step.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "lattice/check_numerics.hpp"
#include "lattice/touching.hpp"

namespace hackle {
namespace {

// To three digits.
double rounded_down(double step) {
  const double unit = std::pow(10.0, std::floor(std::log10(step)) - 2.0);
  return std::isfinite(step) ? std::floor(step / unit) * unit : step;
}

// Returns the step, at most a twentieth shorter, of which the smallest power of ten seconds is a
// multiple: moments that are written in round numbers then lie at steps.
double dividing(double longest) {
  constexpr double max_loss = 0.05;
  if (!std::isfinite(longest) || !(longest > 0.0)) return longest;
  for (double exponent = std::ceil(std::log10(longest));; ++exponent) {
    const double whole = std::pow(10.0, exponent);
    const double step = whole / std::ceil(whole / longest - 1e-9);
    if (step >= (1.0 - max_loss) * longest) return step;
  }
}

}  // namespace

double default_step(double limit, double safety) {
  return dividing(safety * limit);
}

double default_step(const Plate& plate, const Lattice& lattice, double safety) {
  const double longest = longest_step_of_bodies(plate, lattice.grid.dx).longest;
  const double step = std::min(default_step(lattice.step_limit, safety), dividing(longest));
  if (step > 0.0) return step;
  throw Error(ErrorKind::refused, "simulate: no step is short enough for this plate",
              "its damping, contacts or bodies are too stiff or too fast");
}

void check_step(const Plate& plate, const Lattice& lattice, double dt, std::string_view who) {
  const double limit = step_limit(lattice, plate) / step_fraction;
  const auto [longest, body] = longest_step_of_bodies(plate, lattice.grid.dx);
  const double fit = std::min(limit, longest);
  if (dt <= fit * (1.0 + 1e-9)) return;
  const std::string remedy = fmt::format(
      "give simulate a step of {} or less; for what the plate has before simulate() it is found",
      quantity(rounded_down(fit), "s"));
  if (limit >= longest)
    throw Error(ErrorKind::refused,
                fmt::format("{}: in the step of {} it crosses {:.2g} spacings, {:g} are the most",
                            body, quantity(dt, "s"), max_crossed * dt / longest, max_crossed),
                remedy);
  throw Error(ErrorKind::refused,
              fmt::format("{}: the step is {}, above the stability limit of {} while it acts", who,
                          quantity(dt, "s"), quantity(limit, "s")),
              remedy);
}

}  // namespace hackle
