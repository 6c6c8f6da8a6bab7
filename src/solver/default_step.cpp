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

}  // namespace

double default_step(double limit, double safety) {
  return rounded_down(safety * limit);
}

double default_step(const Plate& plate, const Lattice& lattice, double safety) {
  const double longest = longest_step_of_bodies(plate, lattice.grid.dx).longest;
  return std::min(default_step(lattice.step_limit, safety), rounded_down(longest));
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
