// SPDX-License-Identifier: MIT
#include "solver/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/stopwatch.hpp"
#include "base/units.hpp"
#include "solver/statics/statics.hpp"

namespace hackle {
namespace {

constexpr std::int64_t steps_between_checks = 64;

void check(const QuasistaticOptions& options, double begin, double dt) {
  if (!(options.duration > 0.0) || !std::isfinite(options.duration) || options.increments < 1)
    throw Error(
        ErrorKind::refused,
        fmt::format("quasistatic: {} s in {} increments; there must be more than 0 s and at "
                    "least 1 increment",
                    options.duration, options.increments));
  if (!(begin + options.duration <= max_steps * dt))
    throw Error(
        ErrorKind::refused,
        fmt::format("quasistatic: the duration is {}, which is more than {:.0e} steps of {}",
                    quantity(options.duration, "s"), max_steps, quantity(dt, "s")));
  if (!(begin + options.duration / options.increments > begin))
    throw Error(
        ErrorKind::refused,
        fmt::format("quasistatic: an increment of {} cannot be told apart at {}",
                    quantity(options.duration / options.increments, "s"), quantity(begin, "s")),
        "take a longer duration or fewer increments");
}

}  // namespace

// Observers, and the steps at which they may be due next.
class Simulation::Audience {
 public:
  explicit Audience(std::span<Observer* const> observers)
      : observers_(observers), next_(observers.size(), 0), due_(observers.size(), false) {}

  // Lets those see the state that are due, each at its moment. Ranks agree on who looks: all of
  // the plate must be there then.
  void look(Simulation& simulation) {
    const std::int64_t step = simulation.state().step;
    bool looks = false;
    for (std::size_t k = 0; k < observers_.size(); ++k) {
      due_[k] = step >= next_[k] && observers_[k]->due(simulation);
      looks = looks || (due_[k] && observers_[k]->looks_at_nodes());
    }
    if (simulation.plate_.holds_for_any(looks)) simulation.plate_.complete();
    for (std::size_t k = 0; k < observers_.size(); ++k) {
      if (step < next_[k]) continue;
      if (due_[k]) show(simulation, *observers_[k]);
      next_[k] = observers_[k]->next_due(simulation);
    }
  }

  // The same where time goes on without steps.
  void look_anew(Simulation& simulation) {
    std::ranges::fill(next_, 0);
    look(simulation);
  }

 private:
  static void show(Simulation& simulation, Observer& observer) {
    if (observer.looks_at_nodes()) simulation.check_finite();
    simulation.show(observer.moment(simulation));
    observer.observe(simulation);
    simulation.seen_at_.reset();
  }

  std::span<Observer* const> observers_;
  std::vector<std::int64_t> next_;
  std::vector<bool> due_;
};

Simulation::Simulation(Plate plate, Numerics numerics, Execution execution,
                       std::vector<float> strength)
    : plate_(std::move(plate), numerics, execution, std::move(strength)) {
}

Simulation Simulation::resumed(Plate plate, Numerics numerics, Snapshot snapshot,
                               Execution execution) {
  Plate bare = plate;
  bare.loads = {};
  bare.initial_conditions.clear();
  Simulation simulation(std::move(bare), numerics, execution);
  if (!fits(snapshot.state, simulation.lattice()))
    throw Error(ErrorKind::refused, "the state is not one of this plate and lattice");
  simulation.plate_.resume(std::move(plate), std::move(snapshot.state), snapshot.widened_at);
  simulation.plate_.set_borne(std::move(snapshot.borne));
  simulation.plate_.note_broken_bonds(std::move(snapshot.broken_bonds));
  simulation.aim_ = snapshot.aim;
  simulation.plate_.tabulate(simulation.aim_.last_step);
  simulation.divergence_.begin(snapshot.max_energy);
  simulation.solve_seconds_ = snapshot.solve_seconds;
  simulation.course_ = std::move(snapshot.course);
  simulation.check_finite();
  if (simulation.has_arrived()) simulation.show(simulation.aim_.end_time);
  return simulation;
}

Snapshot Simulation::snapshot() const {
  return {
      state(),        aim_,           plate_.borne(), plate_.widened_at(), divergence_.max_energy(),
      solve_seconds_, broken_bonds(), course_};
}

void Simulation::pretend(const TimePoint& point) {
  plate_.state().step = point.step;
  plate_.state().clock = point.clock;
  aim_ = point.aim;
  show(point.time);
}

double Observer::moment(const Simulation& simulation) {
  return simulation.time();
}

void Simulation::step() {
  advance();
  plate_.complete();
}

void Simulation::advance() {
  seen_at_.reset();
  plate_.step();
}

void Simulation::show(double time) {
  const double behind = (plate_.time() - time) / dt();
  if (state().is_start() || !(behind > -1e-6 && behind < 1.0 + 1e-6)) return seen_at_.reset();
  seen_at_.emplace(time, behind);
}

void Simulation::set_loads(Loads loads) {
  plate_.set_loads(std::move(loads), aim_.last_step);
}

void Simulation::restore(State state) {
  plate_.restore(std::move(state));
  begin_anew();
}

void Simulation::begin_anew() {
  seen_at_.reset();
  stop();
  divergence_.begin(plate_.energy());
}

void Simulation::aim(double duration) {
  const Aim next = aim_.after(duration, state().clock, dt());
  plate_.tabulate(next.last_step);
  aim_ = next;
  course_.reset();
}

void Simulation::run(double duration, std::span<Observer* const> observers) {
  aim(duration);
  try {
    go_on(observers);
  } catch (...) {
    stop();  // time not reached is not made up for
    throw;
  }
}

void Simulation::stop() {
  aim_ = {plate_.time(), state().step};
}

void Simulation::go_on(std::span<Observer* const> observers) {
  break_off_ = false;
  seen_at_.reset();
  Audience audience(observers);
  audience.look(*this);
  while (!has_arrived() && !break_off_) {
    {
      const Stopwatch watch(solve_seconds_);
      advance();
    }
    look_after_step(audience);
  }
  plate_.complete();
  check_finite();
  if (has_arrived()) show(aim_.end_time);
}

void Simulation::look_after_step(Audience& audience) {
  if (state().step % steps_between_checks == 0 && divergence_.is_seen(view(), plate_.slab())) {
    plate_.complete();
    Divergence::tell(view());
  }
  audience.look(*this);
  throw_if_to_leave();
}

// Ranks leave after the same step.
void Simulation::throw_if_to_leave() {
  if (!plate_.holds_for_any(interrupted())) return;
  plate_.complete();
  throw Error(ErrorKind::interrupted,
              fmt::format("interrupted after step {}, at {}", state().step, quantity(time(), "s")));
}

RelaxResult Simulation::relax(const RelaxOptions& options) {
  seen_at_.reset();
  course_.reset();
  return Statics(plate_).relax(options);
}

QuasistaticResult Simulation::load_slowly(const QuasistaticOptions& options,
                                          std::span<Observer* const> observers) {
  if (!options.goes_on || !course_) {
    check(options, plate_.time(), dt());
    course_ = SlowCourse{plate_.time(), aim_.end_time + options.duration, 0, {}};
  }
  SlowCourse& course = *course_;
  const double length = std::max(course.end - course.begin, 0.0);
  seen_at_.reset();
  break_off_ = false;
  Audience audience(observers);
  audience.look(*this);
  while (course.increments < options.increments && course.result.bears && !break_off_) {
    try {
      QuasistaticResult result = course.result;
      Statics(plate_).load_to(course.begin + length * (course.increments + 1) / options.increments,
                              options, result);
      course.result = std::move(result);
    } catch (...) {
      begin_anew();
      throw;
    }
    ++course.increments;
    stop();
    audience.look_anew(*this);
  }
  // The time by which a step or a run went too far is not made up for, as in a run.
  if (course.increments == options.increments && course.result.bears && !break_off_)
    aim_.end_time = course.end;
  return std::exchange(course_, {})->result;
}

}  // namespace hackle
