// SPDX-License-Identifier: MIT
#include "output/schedule.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {

Schedule::Schedule(const char* output, double every, const Simulation& simulation)
    : start_(simulation.time()), every_(every) {
  if (every >= simulation.dt() && std::isfinite(every)) return;
  throw Error(ErrorKind::refused,
              fmt::format("{}: every is {}, less than one time step of {}", output,
                          quantity(every, "s"), quantity(simulation.dt(), "s")),
              "a movie of about 100 frames is usual");
}

bool Schedule::reached(const Simulation& simulation) const {
  const double moment = start_ + static_cast<double>(next_) * every_;
  return simulation.time() + 0.5 * simulation.dt() > moment;
}

}  // namespace hackle
