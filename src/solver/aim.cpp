// SPDX-License-Identifier: MIT
#include "solver/aim.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"

namespace hackle {

Aim Aim::after(double duration, const Clock& clock, double dt) const {
  if (!(duration >= 0.0) || !std::isfinite(duration))
    throw Error(ErrorKind::refused,
                fmt::format("run: the duration is {} s, it must be at least 0 s", duration));
  const double end = end_time + duration;
  // Tolerance: an exact multiple of dt must not gain a step by rounding.
  const double steps = std::ceil((end - clock.moment) / dt - 1e-9);
  if (!(steps <= max_steps))
    throw Error(ErrorKind::refused,
                fmt::format("run: the duration is {}, which is more than {:.0e} steps of {}",
                            quantity(duration, "s"), max_steps, quantity(dt, "s")));
  return {end, clock.since + static_cast<std::int64_t>(steps)};
}

}  // namespace hackle
