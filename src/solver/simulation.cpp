// SPDX-License-Identifier: MIT
#include "solver/simulation.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "base/stopwatch.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

constexpr std::int64_t steps_between_checks = 64;

const Plate& checked(const Plate& plate, const Numerics& numerics) {
  Problems problems;
  check(plate, problems);
  check(plate, numerics, available_memory(), problems);
  problems.throw_if_any();
  return plate;
}

// The tables of the kernel (kernel.md 0).
std::vector<BondClass> bond_classes(const Lattice& lattice, const Rimmed& layout, double dt) {
  const double unit = lattice.calibration.c * lattice.grid.dx * dt * dt / lattice.rho;
  const double critical_e = lattice.calibration.s0 * (2.0 + lattice.calibration.s0);
  std::vector<BondClass> classes;
  for (const Images& image : lattice.family.images()) {
    BondClass entry;
    const double L2 = image.a * image.a + image.b * image.b;
    entry.a = image.a;
    entry.b = image.b;
    entry.inverse_L2 = 1.0 / L2;
    entry.pull = unit * image.weight / std::sqrt(L2);
    entry.most = L2 * critical_e;
    entry.columns = image.a;
    entry.rows = image.b * layout.stride();
    entry.first_bit = image.first_bit % 64;
    entry.word = image.first_bit / 64;
    entry.images = image.count();
    classes.push_back(entry);
  }
  return classes;
}

std::vector<std::size_t> first_load_of_rows(const Lattice& lattice) {
  std::vector<std::size_t> first;
  std::size_t at = 0;
  for (int j = 0; j <= lattice.grid.ny; ++j) {
    while (at < lattice.loads.size() && lattice.loads[at].j < j) ++at;
    first.push_back(at);
  }
  return first;
}

}  // namespace

Simulation::Simulation(Plate plate, Numerics numerics, Execution execution)
    : plate_(std::move(plate)),
      numerics_(numerics),
      lattice_(checked(plate_, numerics_), numerics_),
      state_(lattice_),
      dt_(numerics_.step.value_or(default_step(lattice_.step_limit))),
      instruction_set_(execution.instruction_set),
      kernel_(find_kernel({instruction_set_, !lattice_.unbreakable.empty()})),
      classes_(bond_classes(lattice_, state_.layout, dt_)),
      loads_of_row_(first_load_of_rows(lattice_)),
      threads_(execution.threads > 0 ? execution.threads : available_cores()) {
  forces();
}

double Simulation::default_step(double limit) {
  const double wanted = step_fraction * limit;
  const double unit = std::pow(10.0, std::floor(std::log10(wanted)) - 2.0);
  return std::floor(wanted / unit) * unit;
}

void Simulation::restore(State state) {
  state_ = std::move(state);
  end_time_ = time();
  forces();
}

void Simulation::step() {
  half_kick_and_drift();
  count_external_work();
  forces();
  threads_.for_rows(lattice_.grid.ny, [this](int begin, int end) { half_kick_rows(begin, end); });
  ++state_.step;
}

void Simulation::half_kick_and_drift() {
  threads_.for_rows(lattice_.grid.ny, [this](int begin, int end) {
    half_kick_rows(begin, end);
    for (int j = begin; j < end; ++j) {
      const std::size_t first = lattice_.grid.index(0, j);
      double* ux = &state_.ux[static_cast<std::size_t>(state_.layout.at(0, j))];
      double* uy = &state_.uy[static_cast<std::size_t>(state_.layout.at(0, j))];
      for (std::size_t i = 0; i < static_cast<std::size_t>(lattice_.grid.nx); ++i) {
        ux[i] += state_.vx[first + i];
        uy[i] += state_.vy[first + i];
      }
    }
  });
}

void Simulation::half_kick_rows(int row_begin, int row_end) {
  const std::size_t end = lattice_.grid.index(0, row_end);
  for (std::size_t node = lattice_.grid.index(0, row_begin); node < end; ++node) {
    state_.vx[node] += 0.5 * state_.ax[node];
    state_.vy[node] += 0.5 * state_.ay[node];
  }
}

// The loads are constant over a step and v is its displacement: their work is exact.
void Simulation::count_external_work() {
  const double unit = dt_ * dt_ / lattice_.grid.dx;  // m/s2 to lattice units
  for (const LoadedNode& load : lattice_.loads) {
    const std::size_t node = lattice_.grid.index(load.i, load.j);
    state_.external_work +=
        unit * (load.acceleration.x() * state_.vx[node] + load.acceleration.y() * state_.vy[node]);
  }
}

void Simulation::forces() {
  KernelData data;
  data.nx = lattice_.grid.nx;
  data.stride = state_.layout.stride();
  data.plane = static_cast<std::ptrdiff_t>(lattice_.grid.nodes());
  data.classes = classes_.data();
  data.class_count = static_cast<int>(classes_.size());
  data.ux = state_.ux.data() + state_.layout.at(0, 0);
  data.uy = state_.uy.data() + state_.layout.at(0, 0);
  data.ax = state_.ax.data();
  data.ay = state_.ay.data();
  data.bonds = state_.bonds.planes().data();
  data.unbreakable = lattice_.unbreakable.planes().data();
  threads_.for_rows(lattice_.grid.ny, [&](int begin, int end) {
    kernel_(data, begin, end);
    add_loads(begin, end);
  });
}

void Simulation::add_loads(int row_begin, int row_end) {
  const double unit = dt_ * dt_ / lattice_.grid.dx;
  const std::size_t end = loads_of_row_[static_cast<std::size_t>(row_end)];
  for (std::size_t k = loads_of_row_[static_cast<std::size_t>(row_begin)]; k < end; ++k) {
    const LoadedNode& load = lattice_.loads[k];
    const std::size_t node = lattice_.grid.index(load.i, load.j);
    state_.ax[node] += unit * load.acceleration.x();
    state_.ay[node] += unit * load.acceleration.y();
  }
}

void Simulation::run(double duration, std::span<Observer* const> observers) {
  if (!(duration >= 0.0) || !std::isfinite(duration))
    throw Error(ErrorKind::refused,
                fmt::format("run: the duration is {} s, it must be at least 0 s", duration));
  end_time_ += duration;
  // A whole number of steps must not become one more by rounding.
  const auto last_step = static_cast<std::int64_t>(std::ceil(end_time_ / dt_ - 1e-9));
  advance_to(last_step, observers);
}

void Simulation::advance_to(std::int64_t last_step, std::span<Observer* const> observers) {
  const auto let_look = [&] {
    for (Observer* observer : observers) {
      if (!observer->due(*this)) continue;
      check_finite();
      observer->observe(*this);
    }
  };
  let_look();
  while (state_.step < last_step) {
    {
      const Stopwatch watch(solve_seconds_);
      step();
    }
    if (state_.step % steps_between_checks == 0) check_finite();
    let_look();
    if (interrupted()) {
      end_time_ = time();
      throw Error(ErrorKind::interrupted, fmt::format("interrupted after step {}, at {}",
                                                      state_.step, quantity(time(), "s")));
    }
  }
  check_finite();
}

void Simulation::check_finite() const {
  // A NaN or an infinity anywhere makes the sum of v - v differ from 0.
  double sum = 0.0;
  for (const auto* values : {&state_.vx, &state_.vy})
    for (const double value : *values) sum += value - value;
  if (sum == 0.0) return;
  throw Error(
      ErrorKind::run_failed,
      fmt::format("the solution has diverged by step {}, at {}: the step is {}, its limit {}",
                  state_.step, quantity(time(), "s"), quantity(dt_, "s"),
                  quantity(lattice_.step_limit, "s")),
      "take a smaller step or a smaller load");
}

double Simulation::external_work() const {
  // Lattice units of energy per metre: mass of a node rho dx^2, times (dx/dt)^2.
  const double dx = lattice_.grid.dx;
  return state_.external_work * lattice_.rho * dx * dx * (dx / dt_) * (dx / dt_);
}

}  // namespace hackle
