// SPDX-License-Identifier: MIT
#include "solver/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "base/stopwatch.hpp"
#include "base/units.hpp"
#include "lattice/carve.hpp"
#include "solver/bond_energy.hpp"
#include "solver/damping.hpp"
#include "solver/heat_work.hpp"
#include "solver/rigid_motion.hpp"

namespace hackle {
namespace {

constexpr std::int64_t steps_between_checks = 64;

const Plate& checked(const Plate& plate, const Numerics& numerics, InstructionSet set) {
  Problems problems;
  check(plate, problems);
  check(plate, numerics, available_memory(), problems);
  if (numerics.fused && !can_fuse(set))
    problems.add(fmt::format("simulate: there is no fused arithmetic with {} instructions",
                             instruction_set_names[static_cast<std::size_t>(set)]),
                 "leave out fused");
  problems.throw_if_any();
  return plate;
}

Lattice with_strength(Lattice lattice, std::vector<float> strength) {
  Problems problems;
  if (!strength.empty() && strength.size() != lattice.grid.nodes())
    problems.add(fmt::format("simulate: strength has {} values, the lattice {} nodes",
                             strength.size(), lattice.grid.nodes()),
                 "give one for every node, or none");
  if (!std::ranges::all_of(strength, [](float s) { return s > 0.0F; }))
    problems.add("simulate: a strength is not above 0", "give a share of the critical stretch");
  problems.throw_if_any();
  if (!strength.empty()) lattice.strength = std::move(strength);
  return lattice;
}

void set_in_motion(const std::vector<Start>& starts, const Lattice& lattice, double dt,
                   State& state) {
  for (const Start& start : starts)
    for_nodes_in(start.region, lattice.grid, [&](int i, int j) {
      if (lattice.is_void(i, j)) return;
      const Vec2 place = lattice.grid.position(i, j);
      state.set_u(i, j, state.u(i, j) + start.displacement.at(place) / lattice.grid.dx);
      state.set_v(i, j, state.v(i, j) + start.velocity.at(place) * (dt / lattice.grid.dx));
    });
}

using AnyEngine = std::variant<Engine<double>, Engine<float>>;

AnyEngine engine_for(Precision precision, const Lattice& lattice, const EngineOptions& options,
                     const Threads& threads) {
  if (precision == Precision::f32) return Engine<float>(lattice, options, threads);
  return Engine<double>(lattice, options, threads);
}

template <class T>
std::size_t bytes_of(const T& values) {
  return values.size() * sizeof(typename T::value_type);
}

}  // namespace

Simulation::Simulation(Plate plate, Numerics numerics, Execution execution,
                       std::vector<float> strength)
    : plate_(std::move(plate)),
      numerics_(numerics),
      lattice_(
          with_strength(Lattice(checked(plate_, numerics_, execution.instruction_set), numerics_),
                        std::move(strength))),
      state_(lattice_, numerics_.precision),
      dt_(numerics_.step.value_or(default_step(lattice_.step_limit))),
      loading_(plate_, lattice_, dt_),
      heat_(plate_, lattice_, dt_),
      instruction_set_(execution.instruction_set),
      threads_(execution.threads > 0 ? execution.threads : available_cores()),
      engine_(engine_for(numerics_.precision, lattice_, options(), threads_)) {
  if (!plate_.starts.empty() || !heat_.empty()) start();
  prepare();
}

EngineOptions Simulation::options() const {
  return {.dt = dt_,
          .heated = !heat_.empty(),
          .fidelity = numerics_.fidelity,
          .breaking = numerics_.breaking,
          .set = instruction_set_,
          .arithmetic = numerics_.fused ? Arithmetic::fused : Arithmetic::plain};
}

double Simulation::default_step(double limit) {
  const double wanted = step_fraction * limit;
  const double unit = std::pow(10.0, std::floor(std::log10(wanted)) - 2.0);
  return std::floor(wanted / unit) * unit;
}

void Simulation::restore(State state) {
  if (state.precision() != state_.precision())
    engine_ = engine_for(state.precision(), lattice_, options(), threads_);
  state_ = std::move(state);
  borne_.clear();
  stop();
  prepare();
}

void Simulation::show(Snapshot snapshot) {
  plate_.loads.impactors = std::move(snapshot.impactors);
  heat_.hold(std::move(snapshot.thermal_strain));
  state_ = std::move(snapshot.state);
  stop();
}

// The energy that the start gives is accounted for as work.
void Simulation::start() {
  heat_.update(lattice_, state_);
  set_in_motion(plate_.starts, lattice_, dt_, state_);
  double doubled = 0.0;
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i)
      if (!lattice_.is_void(i, j))
        doubled +=
            lattice_.material_at(i, j).material.rho / lattice_.rho * state_.v(i, j).squaredNorm();
  const BondEnergy bonds = bond_energy(lattice_, state_, heat_.values());
  state_.external_work = 0.5 * doubled + bonds.held / energy_unit();
}

void Simulation::prepare() {
  loading_.begin(lattice_, state_);
  loading_.update(lattice_, state_, step_seconds_.loads);
  heat_.update(lattice_, state_);
  std::visit(
      [this](auto& engine) {
        engine.set_loads(loading_);
        if (!heat_.empty()) engine.set_heat(lattice_, heat_.values());
        engine.prepare(lattice_, state_);
      },
      engine_);
}

void Simulation::set_loads(Loads loads) {
  Plate plate = plate_;
  plate.loads = std::move(loads);
  Problems problems;
  check(plate, problems);
  problems.throw_if_any();
  Loading loading(plate, lattice_, dt_);
  loading.tabulate(state_.clock, state_.step, std::max(state_.step, last_step_) + 1);
  ThermalStrain heat(plate, lattice_, dt_);
  heat.tabulate(state_.clock, state_.step, std::max(state_.step, last_step_) + 1);
  heat.update(lattice_, state_);
  loading.begin(lattice_, state_);
  const bool rebuild = heat.empty() != heat_.empty();
  if (!heat.empty() || !heat_.empty())
    state_.external_work += heat_work(lattice_, state_, heat_.before(lattice_, state_),
                                      heat.before(lattice_, state_), threads_) /
                            energy_unit();
  // What is let go has done its work.
  if (loading.led().empty()) state_.external_work += std::exchange(state_.work_ahead, 0.0);
  loading_ = std::move(loading);
  heat_ = std::move(heat);
  plate_ = std::move(plate);
  if (rebuild) engine_ = engine_for(state_.precision(), lattice_, options(), threads_);
  prepare();
}

void Simulation::step() {
  if (plate_.loads.damping > 0.0) damp_motion();
  if (!heat_.empty()) count_heat_work();
  std::visit([this](auto& engine) { engine.step(lattice_, state_); }, engine_);
  ++state_.step;
  count_external_work();
  if (!heat_.empty()) take_heat();
  take_loads();
  if (state_.precision() == Precision::f32 && state_.step % steps_between_checks == 0)
    keep_f32_exact();
}

void Simulation::damp_motion() {
  const Stopwatch watch(step_seconds_.damping);
  state_.damped += damp(lattice_, std::exp(-plate_.loads.damping * dt_), threads_, state_);
}

// For the step to come.
void Simulation::take_loads() {
  std::visit(
      [this](auto& engine) {
        loading_.follow(lattice_, state_, engine.losses(), step_seconds_.loads);
        if (loading_.update(lattice_, state_, step_seconds_.loads)) engine.set_loads(loading_);
      },
      engine_);
  if (loading_.varies()) loading_.add_work(lattice_, state_, state_.external_work);
}

// From half a step before now to half a step after.
void Simulation::count_heat_work() {
  if (!heat_.changes_around(state_)) return;
  const Stopwatch watch(step_seconds_.heat);
  state_.external_work += heat_work(lattice_, state_, heat_.before(lattice_, state_),
                                    heat_.after(lattice_, state_), threads_) /
                          energy_unit();
}

void Simulation::take_heat() {
  const Stopwatch watch(step_seconds_.heat);
  if (heat_.update(lattice_, state_))
    std::visit([this](auto& engine) { engine.set_heat(lattice_, heat_.values()); }, engine_);
}

// At fixed steps, so that the bits do not depend on how a run is cut into pieces.
void Simulation::keep_f32_exact() {
  const bool moved = take_out_drift(state_, lattice_.material);
  if (is_too_wide_for_f32(state_, lattice_.least_stretch(), lattice_.material)) {
    state_ = in_f64(state_);
    widened_at_ = time();
    engine_ = engine_for(Precision::f64, lattice_, options(), threads_);
    prepare();
  } else if (moved) {
    prepare();
  }
}

void Simulation::count_external_work() {
  loading_.add_work(lattice_, state_, state_.external_work);
  state_.work_ahead = 0.0;
  if (loading_.led().empty()) return;
  std::visit(
      [this](const auto& engine) {
        const auto work = engine.work_of_leads();
        state_.external_work += work.done;
        state_.work_ahead = work.ahead;
      },
      engine_);
}

void Simulation::aim(double duration) {
  if (!(duration >= 0.0) || !std::isfinite(duration))
    throw Error(ErrorKind::refused,
                fmt::format("run: the duration is {} s, it must be at least 0 s", duration));
  const double end = end_time_ + duration;
  // A whole number of steps must not become one more by rounding.
  const double steps = std::ceil((end - state_.clock.moment) / dt_ - 1e-9);
  if (!(steps <= most_steps))
    throw Error(ErrorKind::refused,
                fmt::format("run: the duration is {}, which is more than {:.0e} steps of {}",
                            quantity(duration, "s"), most_steps, quantity(dt_, "s")));
  const auto last_step = state_.clock.since + static_cast<std::int64_t>(steps);
  loading_.tabulate(state_.clock, state_.step, last_step + 1);
  heat_.tabulate(state_.clock, state_.step, last_step + 1);
  end_time_ = end;
  last_step_ = last_step;
}

void Simulation::run(double duration, std::span<Observer* const> observers) {
  aim(duration);
  try {
    go_on(observers);
  } catch (...) {
    stop();  // what was not reached is not owed
    throw;
  }
}

void Simulation::stop() {
  end_time_ = time();
  last_step_ = state_.step;
}

void Simulation::let_look(std::span<Observer* const> observers) const {
  for (Observer* observer : observers) {
    if (!observer->due(*this)) continue;
    check_finite();
    observer->observe(*this);
  }
}

void Simulation::go_on(std::span<Observer* const> observers) {
  break_off_ = false;
  let_look(observers);
  while (!has_arrived() && !break_off_) {
    {
      const Stopwatch watch(solve_seconds_);
      step();
    }
    look_after_step(observers);
  }
  check_finite();
}

void Simulation::look_after_step(std::span<Observer* const> observers) {
  if (state_.step % steps_between_checks == 0) check_finite();
  let_look(observers);
  if (interrupted())
    throw Error(ErrorKind::interrupted, fmt::format("interrupted after step {}, at {}", state_.step,
                                                    quantity(time(), "s")));
}

void Simulation::check_finite() const {
  // What a field can hold, which is in single precision.
  constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
  const Grid& grid = lattice_.grid;
  const double u_most = most / grid.dx, v_most = most / (grid.dx / dt_);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double u = (state_.origin + state_.u(i, j)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
      const double v = state_.v(i, j).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
      if (u < u_most && v < v_most) continue;
      const Vec2 place = grid.position(i, j);
      throw Error(ErrorKind::run_failed,
                  fmt::format("the solution has diverged by step {}, at {}, at ({}, {}): the step "
                              "is {}, its limit {}",
                              state_.step, quantity(time(), "s"), quantity(place.x(), "m"),
                              quantity(place.y(), "m"), quantity(dt_, "s"),
                              quantity(lattice_.step_limit, "s")),
                  "take a smaller step or a smaller load");
    }
}

// Lattice units of energy per metre: mass of a node rho dx^2, times (dx/dt)^2.
double Simulation::energy_unit() const {
  const double dx = lattice_.grid.dx;
  return lattice_.rho * dx * dx * (dx / dt_) * (dx / dt_);
}

double Simulation::external_work() const {
  double work = (state_.external_work + state_.work_ahead) * energy_unit();
  if (!heat_.empty() && heat_.changes_until(state_))
    work += heat_work(lattice_, state_, heat_.before(lattice_, state_), heat_.values(), threads_);
  return work;
}

double Simulation::contact_energy() const {
  return loading_.contact_energy() * energy_unit();
}

double Simulation::damped_energy() const {
  return state_.damped * energy_unit();
}

double Simulation::released_energy() const {
  return state_.released * energy_unit();
}

double Simulation::kinetic_energy() const {
  const std::vector<Vec2> now = velocities();
  double sum = 0.0;
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i)
      if (!lattice_.is_void(i, j))
        sum +=
            lattice_.material_at(i, j).material.rho * now[lattice_.grid.index(i, j)].squaredNorm();
  return 0.5 * lattice_.grid.dx * lattice_.grid.dx * sum;
}

Vec2 Simulation::displacement(int i, int j) const {
  return lattice_.grid.dx * (state_.origin + state_.u(i, j));
}

// v is half a step old, except at the start.
std::vector<Vec2> Simulation::velocities() const {
  const Grid& grid = lattice_.grid;
  const double unit = grid.dx / dt_;
  std::vector<Vec2> result(grid.nodes());
  const auto fill = [&](const auto& kick) {
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        result[grid.index(i, j)] = unit * (state_.v(i, j) + kick(state_.layout.at(i, j)));
  };
  if (state_.is_start()) {
    fill([](std::ptrdiff_t) { return Vec2(0, 0); });
    return result;
  }
  std::visit(
      [&]<class Real>(Engine<Real>& engine) {
        Values<Real> ax, ay;
        engine.accelerations(lattice_, state_, ax, ay);
        fill([&](std::ptrdiff_t at) {
          const auto place = static_cast<std::size_t>(at);
          return Vec2(0.5 * static_cast<double>(ax[place]), 0.5 * static_cast<double>(ay[place]));
        });
      },
      engine_);
  return result;
}

bool Simulation::holds(int i, int j, int column, int row) const {
  return hackle::holds(lattice_.grid, lattice_.family, state_.bonds, i, j, column, row);
}

const std::vector<Loss>& Simulation::losses() const {
  return std::visit([](const auto& engine) -> const std::vector<Loss>& { return engine.losses(); },
                    engine_);
}

const PathCounts& Simulation::path_counts() const {
  return std::visit([](const auto& engine) -> const PathCounts& { return engine.path_counts(); },
                    engine_);
}

std::size_t Simulation::bytes() const {
  const std::size_t motion = std::visit(
      [](const auto& m) {
        return bytes_of(m.ux) + bytes_of(m.uy) + bytes_of(m.vx) + bytes_of(m.vy) +
               bytes_of(m.threshold);
      },
      state_.motion);
  const std::size_t engine = std::visit([](const auto& e) { return e.bytes(); }, engine_);
  return motion + engine + bytes_of(state_.bonds.words()) + bytes_of(lattice_.bonds.words()) +
         bytes_of(lattice_.unbreakable.words()) + bytes_of(lattice_.born) +
         bytes_of(lattice_.strength) + bytes_of(lattice_.material) + heat_.bytes();
}

}  // namespace hackle
