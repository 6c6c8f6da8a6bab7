// SPDX-License-Identifier: MIT
#include "output/run/progress_observer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"

namespace hackle {

void ProgressObserver::observe(const Simulation& simulation) {
  const double node_steps = static_cast<double>(simulation.state().step) *
                            static_cast<double>(simulation.lattice().grid.nodes());
  progress_.show(
      fraction(simulation),
      fmt::format("step {}  {} of {}  {:.3g} M node-steps/s", grouped(simulation.state().step),
                  quantity(simulation.time(), "s"), quantity(end_, "s"),
                  1e-6 * node_steps / std::max(simulation.solve_seconds(), 1e-9)));
}

double ProgressObserver::fraction(const Simulation& simulation) const {
  const double span = std::max(end_ - start_, simulation.dt());
  return std::clamp((simulation.time() - start_) / span, 0.0, 1.0);
}

void Break::after_seconds(double seconds) {
  end_ = Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

bool Break::due(const Simulation& simulation) {
  const std::int64_t step = simulation.state().step;
  if ((step > start_ && Clock::now() >= end_) || step >= last_) simulation_.break_off();
  return false;
}

void Interrupt::observe(const Simulation& simulation) {
  done_ = true;
  throw Error(ErrorKind::interrupted,
              fmt::format("interrupted after step {}", simulation.state().step));
}

}  // namespace hackle
