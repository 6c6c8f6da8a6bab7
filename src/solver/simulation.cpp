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
#include "lattice/check_numerics.hpp"
#include "lattice/touching.hpp"
#include "solver/bond_energy.hpp"
#include "solver/damping.hpp"
#include "solver/exact_sum.hpp"
#include "solver/f32_range.hpp"
#include "solver/heat_work.hpp"
#include "solver/meetings.hpp"

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

// The initial condition of some nodes, in lattice units.
struct SpreadCondition {
  std::vector<std::size_t> at;  // Grid::index
  std::vector<Vec2> u, v;
};

SpreadCondition spread(const InitialCondition& start, const Lattice& lattice, double dt) {
  SpreadCondition spread;
  for_nodes_in(start.region, lattice.grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    const Vec2 place = lattice.grid.position(i, j);
    spread.at.push_back(lattice.grid.index(i, j));
    spread.u.push_back(start.displacement.at(place) / lattice.grid.dx);
    spread.v.push_back(start.velocity.at(place) * (dt / lattice.grid.dx));
  });
  return spread;
}

// The sum of one quantity over all starts, by Grid::index.
std::vector<Vec2> sum_of(const std::vector<SpreadCondition>& starts,
                         std::vector<Vec2> SpreadCondition::*quantity,
                         const std::vector<Meeting>& crowds, const Grid& grid) {
  std::vector<Vec2> sum(grid.nodes(), Vec2(0, 0));
  for (const SpreadCondition& start : starts)
    for (std::size_t k = 0; k < start.at.size(); ++k) sum[start.at[k]] += (start.*quantity)[k];
  for (const Meeting& crowd : crowds) {
    ExactVectorSum exact;
    for (const auto& [start, entry] : crowd.entries) exact.add((starts[start].*quantity)[entry]);
    sum[crowd.place] = exact.value();
  }
  return sum;
}

// Rounded once to the precision of the state, in whatever order the starts were said.
void set_in_motion(const std::vector<InitialCondition>& starts, const Lattice& lattice, double dt,
                   State& state) {
  if (starts.empty()) return;
  const Grid& grid = lattice.grid;
  std::vector<SpreadCondition> spreads;
  spreads.reserve(starts.size());
  for (const InitialCondition& start : starts) spreads.push_back(spread(start, lattice, dt));
  std::vector<const std::vector<std::size_t>*> lists;
  lists.reserve(spreads.size());
  for (const SpreadCondition& start : spreads) lists.push_back(&start.at);
  const std::vector<Meeting> crowds = find_meetings(lists, grid.nodes());
  const std::vector<Vec2> u = sum_of(spreads, &SpreadCondition::u, crowds, grid),
                          v = sum_of(spreads, &SpreadCondition::v, crowds, grid);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      state.set_u(i, j, u[grid.index(i, j)]);
      state.set_v(i, j, v[grid.index(i, j)]);
    }
}

// To three digits.
double rounded_down(double step) {
  const double unit = std::pow(10.0, std::floor(std::log10(step)) - 2.0);
  return std::isfinite(step) ? std::floor(step / unit) * unit : step;
}

// Checks the step for discs that are added later; those of the plate are checked with the numerics.
// The limit holds for nodes deep in the plate; for those at a rim, which lack half their bonds, the
// reserve of the default step is enough (dense eigenvalues, m = 3 to 6).
void check_step(const Plate& plate, const Lattice& lattice, double dt) {
  const double limit = step_limit(lattice, plate) / step_fraction;
  const double longest = longest_step_of_impact(plate, lattice.grid.dx);
  const double fit = std::min(limit, longest);
  if (dt <= fit * (1.0 + 1e-9)) return;
  throw Error(
      ErrorKind::refused,
      limit < longest
          ? fmt::format("impactor: the step is {}, above the stability limit of {} while it pushes",
                        quantity(dt, "s"), quantity(limit, "s"))
          : fmt::format("impactor: in the step of {} it crosses {:.2g} spacings, {:g} are the most",
                        quantity(dt, "s"), max_crossed * dt / longest, max_crossed),
      fmt::format("give simulate a step of {} or less; for an impactor that the plate has before "
                  "simulate() it is found",
                  quantity(rounded_down(fit), "s")));
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
      dt_(numerics_.step.value_or(default_step(plate_, lattice_))),
      loading_(plate_, lattice_, dt_),
      heat_(plate_, lattice_, dt_),
      instruction_set_(execution.instruction_set),
      threads_(execution.threads > 0 ? execution.threads : available_cores()),
      engine_(engine_for(numerics_.precision, lattice_, options(), threads_)) {
  if (!plate_.initial_conditions.empty() || !heat_.empty()) start();
  throw_if_interrupted();
  prepare();
  state_.external_work += loading_.contact_energy();  // of faces that the start presses
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
  return rounded_down(step_fraction * limit);
}

double Simulation::default_step(const Plate& plate, const Lattice& lattice) {
  const double longest = longest_step_of_impact(plate, lattice.grid.dx);
  return std::min(default_step(lattice.step_limit), rounded_down(longest));
}

void Simulation::restore(State state) {
  if (state.precision() != state_.precision())
    engine_ = engine_for(state.precision(), lattice_, options(), threads_);
  state_ = std::move(state);
  borne_.clear();
  stop();
  prepare();
  max_energy_ = energy_of_state() + loading_.contact_energy();
}

void Simulation::show(Snapshot snapshot) {
  plate_.loads.impactors = std::move(snapshot.impactors);
  heat_.hold(std::move(snapshot.thermal_strain));
  state_ = std::move(snapshot.state);
  stop();
}

// The energy of the initial condition is booked as external work.
void Simulation::start() {
  heat_.update(lattice_, state_);
  set_in_motion(plate_.initial_conditions, lattice_, dt_, state_);
  state_.external_work = energy_of_state();
}

double Simulation::energy_of_state() const {
  double doubled = 0.0;
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i)
      if (!lattice_.is_void(i, j))
        doubled +=
            lattice_.material_at(i, j).material.rho / lattice_.rho * state_.v(i, j).squaredNorm();
  const BondEnergy bonds = bond_energy(lattice_, state_, heat_.values());
  return 0.5 * doubled + bonds.held / energy_unit();
}

void Simulation::prepare() {
  heat_.update(lattice_, state_);
  loading_.begin(lattice_, state_);
  loading_.update(lattice_, state_, heat_.values(), step_seconds_.loads);
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
  const bool more_discs = plate.loads.impactors.size() > plate_.loads.impactors.size();
  if (more_discs && !numerics_.force_step) check_step(plate, lattice_, dt_);
  loading.tabulate(state_.clock, state_.step, std::max(state_.step, last_step_) + 1);
  ThermalStrain heat(plate, lattice_, dt_);
  heat.tabulate(state_.clock, state_.step, std::max(state_.step, last_step_) + 1);
  heat.update(lattice_, state_);
  loading.begin(lattice_, state_);
  const bool rebuild = heat.empty() != heat_.empty();
  if (!heat.empty() || !heat_.empty())
    state_.external_work +=
        heat_work_between(heat_.before(lattice_, state_), heat.before(lattice_, state_));
  const double work = work_of_half_step(), loss = lost_in_half_step();
  const double damping = plate.loads.damping;
  plate.loads.damping = plate_.loads.damping;
  loading_ = std::move(loading);
  heat_ = std::move(heat);
  plate_ = std::move(plate);
  if (more_discs) lattice_.step_limit = step_limit(lattice_, plate_);
  if (rebuild) engine_ = engine_for(state_.precision(), lattice_, options(), threads_);
  prepare();
  state_.external_work += work_of_half_step() - work;
  state_.damped += loss - lost_in_half_step();  // other nodes are led
  if (damping != plate_.loads.damping) change_damping(damping);
}

// v becomes the velocity of now, as at the start: the rate of the step in which it was found does
// not hold for the next one.
void Simulation::change_damping(double rate) {
  const std::vector<Vec2> now = velocities();
  state_.external_work = external_work() / energy_unit();
  state_.damped = damped_energy() / energy_unit();
  const double unit = dt_ / lattice_.grid.dx;
  for (int j = 0; j < lattice_.grid.ny; ++j)
    for (int i = 0; i < lattice_.grid.nx; ++i)
      state_.set_v(i, j, unit * now[lattice_.grid.index(i, j)]);
  state_.start = state_.step;
  plate_.loads.damping = rate;
  prepare();
}

void Simulation::step() {
  const double kick = plate_.loads.damping > 0.0 ? damp_motion() : state_.is_start() ? 0.5 : 1.0;
  if (!heat_.empty()) count_heat_work();
  std::visit([&](auto& engine) { engine.step(lattice_, state_, kick); }, engine_);
  ++state_.step;
  count_external_work();
  if (!heat_.empty()) take_heat();
  take_loads();
  if (state_.precision() == Precision::f32 && state_.step % steps_between_checks == 0)
    keep_f32_exact();
}

// Damps v from its own time to the middle of the next step (src/solver/README.md 3.7). Returns the
// kick that goes with it.
double Simulation::damp_motion() {
  const Stopwatch watch(step_seconds_.damping);
  const Damping step(plate_.loads.damping * dt_), half(0.5 * plate_.loads.damping * dt_);
  const bool starts = state_.is_start();
  state_.damped += (starts ? step.first : step.loss) *
                   free_motion(lattice_, loading_.prescribed(), threads_, state_);
  damp(lattice_, loading_.prescribed(), starts ? half.keep : step.keep, threads_, state_);
  return starts ? 0.5 * half.yield : step.yield;
}

// The work of all accelerations in the second half of the last step. What acts at a step does half
// its work in the step before, so changed loads or temperatures change that work
// (src/solver/README.md 3.4).
double Simulation::work_of_half_step() const {
  if (state_.is_start()) return 0.0;
  const Grid& grid = lattice_.grid;
  const std::vector<Vec2> a = accelerations();
  double sum = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (!lattice_.is_void(i, j))
        sum += lattice_.material_at(i, j).material.rho / lattice_.rho *
               a[grid.index(i, j)].dot(state_.v(i, j));
  return 0.5 * sum;
}

double Simulation::lost_in_half_step() const {
  if (!(plate_.loads.damping > 0.0) || state_.is_start()) return 0.0;
  return 0.5 * Damping(plate_.loads.damping * dt_).loss *
         free_motion(lattice_, loading_.prescribed(), threads_, state_);
}

// Finds loads, contacts and impacts for the next step.
void Simulation::take_loads() {
  std::visit(
      [this](auto& engine) {
        loading_.follow(lattice_, state_, heat_.values(), engine.broken_bonds(),
                        step_seconds_.loads);
        if (loading_.update(lattice_, state_, heat_.values(), step_seconds_.loads))
          engine.set_loads(loading_);
      },
      engine_);
  state_.contact_lost += loading_.contact_lost();
  if (loading_.varies()) loading_.add_work(lattice_, state_, state_.external_work);
}

// Counts the work of heating from half a step before now to half a step after.
void Simulation::count_heat_work() {
  if (!heat_.changes_around(state_)) return;
  const Stopwatch watch(step_seconds_.heat);
  state_.external_work +=
      heat_work_between(heat_.before(lattice_, state_), heat_.after(lattice_, state_));
}

double Simulation::heat_work_between(const std::vector<double>& before,
                                     const std::vector<double>& after) const {
  return heat_work(lattice_, state_, before, after, threads_) / energy_unit() +
         loading_.contact_heat_work(before, after);
}

void Simulation::take_heat() {
  const Stopwatch watch(step_seconds_.heat);
  if (heat_.update(lattice_, state_))
    std::visit([this](auto& engine) { engine.set_heat(lattice_, heat_.values()); }, engine_);
}

// At fixed steps, so that the bits do not depend on how a run is cut into pieces.
void Simulation::keep_f32_exact() {
  const bool moved = take_out_drift(state_, lattice_.material);
  if (is_too_wide_for_f32(state_, lattice_.min_stretch(), lattice_.material)) {
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
  if (loading_.prescribed().empty()) return;
  state_.external_work +=
      std::visit([](const auto& engine) { return engine.prescribed_work(); }, engine_);
}

// The work of supports in the second half of the last step: they balance all forces on prescribed
// nodes (src/solver/README.md 3.5).
double Simulation::prescribed_work_of_half_step() const {
  if (loading_.prescribed().empty() || state_.is_start()) return 0.0;
  const std::vector<Vec2> a = accelerations();
  double sum = 0.0;
  for (const PrescribedNode& node : loading_.prescribed()) {
    const Vec2& push = a[lattice_.grid.index(node.i, node.j)];
    const Vec2 v = state_.v(node.i, node.j);
    if (node.along_x) sum -= node.inertia * push.x() * v.x();
    if (node.along_y) sum -= node.inertia * push.y() * v.y();
  }
  return 0.5 * sum;
}

void Simulation::aim(double duration) {
  if (!(duration >= 0.0) || !std::isfinite(duration))
    throw Error(ErrorKind::refused,
                fmt::format("run: the duration is {} s, it must be at least 0 s", duration));
  const double end = end_time_ + duration;
  // Tolerance: an exact multiple of dt must not gain a step by rounding.
  const double steps = std::ceil((end - state_.clock.moment) / dt_ - 1e-9);
  if (!(steps <= max_steps))
    throw Error(ErrorKind::refused,
                fmt::format("run: the duration is {}, which is more than {:.0e} steps of {}",
                            quantity(duration, "s"), max_steps, quantity(dt_, "s")));
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
  if (state_.step % steps_between_checks == 0) check_energy(check_motion());
  let_look(observers);
  if (interrupted())
    throw Error(ErrorKind::interrupted, fmt::format("interrupted after step {}, at {}", state_.step,
                                                    quantity(time(), "s")));
}

void Simulation::check_finite() const {
  check_motion();
}

// Returns the sum of v^2.
double Simulation::check_motion() const {
  // What a field can hold, which is in single precision.
  constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
  const Grid& grid = lattice_.grid;
  const double u_most = most / grid.dx, v_most = most / (grid.dx / dt_);
  double sum = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 moves = state_.v(i, j);
      const double u = (state_.origin + state_.u(i, j)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
      const double v = moves.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
      if (!(u < u_most && v < v_most)) throw_diverged(i, j);
      sum += moves.squaredNorm();
    }
  return sum;
}

// All motion comes from work, so kinetic energy cannot exceed the most that was put in, apart from
// the error of the step. If it is far above, the solution has diverged.
void Simulation::check_energy(double motion) {
  constexpr double beyond_reason = 1000.0;
  max_energy_ = std::max(max_energy_, std::abs(state_.external_work));
  if (0.5 * motion <= beyond_reason * max_energy_) return;
  const Grid& grid = lattice_.grid;
  int fastest_i = 0, fastest_j = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (state_.v(i, j).squaredNorm() > state_.v(fastest_i, fastest_j).squaredNorm())
        fastest_i = i, fastest_j = j;
  throw_diverged(fastest_i, fastest_j);
}

void Simulation::throw_diverged(int i, int j) const {
  const Vec2 place = lattice_.grid.position(i, j);
  throw Error(
      ErrorKind::run_failed,
      fmt::format("the solution has diverged by step {}, at {}, at ({}, {}): the step "
                  "is {}, its limit {}",
                  state_.step, quantity(time(), "s"), quantity(place.x(), "m"),
                  quantity(place.y(), "m"), quantity(dt_, "s"), quantity(lattice_.step_limit, "s")),
      "take a smaller step or a smaller load");
}

// Lattice units of energy per metre: mass of a node rho dx^2, times (dx/dt)^2.
double Simulation::energy_unit() const {
  const double dx = lattice_.grid.dx;
  return lattice_.rho * dx * dx * (dx / dt_) * (dx / dt_);
}

double Simulation::external_work() const {
  double work = state_.external_work + prescribed_work_of_half_step();
  if (!heat_.empty() && heat_.changes_until(state_))
    work += heat_work_between(heat_.before(lattice_, state_), heat_.values());
  return work * energy_unit();
}

double Simulation::contact_energy() const {
  return (loading_.contact_energy() + state_.contact_lost) * energy_unit();
}

double Simulation::damped_energy() const {
  double damped = state_.damped;
  if (plate_.loads.damping > 0.0 && !state_.is_start())
    damped += Damping(plate_.loads.damping * dt_).last *
              free_motion(lattice_, loading_.prescribed(), threads_, state_);
  return damped * energy_unit();
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

std::vector<Vec2> Simulation::accelerations() const {
  const Grid& grid = lattice_.grid;
  std::vector<Vec2> result(grid.nodes());
  std::visit(
      [&]<class Real>(Engine<Real>& engine) {
        Values<Real> ax, ay;
        engine.accelerations(lattice_, state_, ax, ay);
        for (int j = 0; j < grid.ny; ++j)
          for (int i = 0; i < grid.nx; ++i) {
            const auto at = static_cast<std::size_t>(state_.layout.at(i, j));
            result[grid.index(i, j)] = {ax[at], ay[at]};
          }
      },
      engine_);
  return result;
}

// v is half a step old, except at the start; prescribed components need no correction.
std::vector<Vec2> Simulation::velocities() const {
  const Grid& grid = lattice_.grid;
  const Damping half(0.5 * plate_.loads.damping * dt_);
  const bool starts = state_.is_start();
  const double unit = grid.dx / dt_, keep = starts ? 1.0 : half.keep;
  std::vector<Vec2> result(grid.nodes(), Vec2(0, 0));
  if (!starts) result = accelerations();
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      Vec2& v = result[grid.index(i, j)];
      v = unit * (keep * state_.v(i, j) + 0.5 * half.yield * v);
    }
  for (const PrescribedNode& node : loading_.prescribed()) {
    const Vec2 prescribed = unit * state_.v(node.i, node.j);
    Vec2& v = result[grid.index(node.i, node.j)];
    v = {node.along_x ? prescribed.x() : v.x(), node.along_y ? prescribed.y() : v.y()};
  }
  return result;
}

bool Simulation::holds(int i, int j, int column, int row) const {
  return hackle::holds(lattice_.grid, lattice_.family, state_.bonds, i, j, column, row);
}

const std::vector<BrokenBond>& Simulation::broken_bonds() const {
  return std::visit(
      [](const auto& engine) -> const std::vector<BrokenBond>& { return engine.broken_bonds(); },
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
         bytes_of(lattice_.unbreakable.words()) + bytes_of(lattice_.initial_neighbours) +
         bytes_of(lattice_.strength) + bytes_of(lattice_.material) + heat_.bytes() +
         loading_.bytes();
}

}  // namespace hackle
