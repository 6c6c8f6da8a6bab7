// SPDX-License-Identifier: MIT
#include "solver/statics/static_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/units.hpp"
#include "lattice/surface.hpp"
#include "solver/statics/coarse_space.hpp"
#include "solver/statics/conjugate_gradient.hpp"

namespace hackle {
namespace {

constexpr int max_newton_steps = 40;
constexpr int max_halvings = 10;
constexpr double max_for_old_tangent = 0.1;
constexpr int few_iterations = 10;
constexpr double share_of_step = 1e-4;  // share of the force that a step may leave for the next

// Returns 0 where a node is prescribed.
NodeVectors mobile_of(const NodeLayout& layout, const std::vector<PrescribedNode>& prescribed) {
  NodeVectors mobile(layout);
  for (int j = 0; j < layout.ny; ++j)
    for (int i = 0; i < layout.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout.at(i, j));
      mobile.x[at] = mobile.y[at] = 1.0;
    }
  for (const PrescribedNode& node : prescribed) {
    const auto at = static_cast<std::size_t>(layout.at(node.i, node.j));
    if (node.along_x) mobile.x[at] = 0.0;
    if (node.along_y) mobile.y[at] = 0.0;
  }
  return mobile;
}

[[noreturn]] void fail(const RelaxResult& result, const std::string& who) {
  throw Error(ErrorKind::run_failed,
              fmt::format("{}: no equilibrium is found; after {} Newton steps {:.2g} of the "
                          "largest force is not in balance",
                          who, result.newton_steps, result.residual),
              "the plate may not bear these loads: try smaller ones, or hold it by a support");
}

}  // namespace

StaticEquilibrium::StaticEquilibrium(const Lattice& lattice, const State& state,
                                     const Actions& actions, std::span<const double> heat,
                                     const Threads& threads, RigidContacts contacts)
    : lattice_(&lattice),
      state_(&state),
      net_(lattice, state, threads, heat),
      contacts_(std::move(contacts)),
      u_(displacements_of(state)),
      load_(state.layout),
      mobile_(mobile_of(state.layout, actions.prescribed)),
      move_(state.layout),
      residual_(state.layout),
      pull_(state.layout),
      push_(state.layout),
      fragments_(fragments()) {
  take_loads(actions.forces, load_);
  take_prescribed(actions.prescribed);
  hold_lonely_nodes();
  for (int j = 0; j < lattice.grid.ny; ++j)
    largest_load_ = std::max(largest_load_, largest_of_row(state.layout, load_, j));
  set_out();
}

StaticEquilibrium::~StaticEquilibrium() = default;

// Holds nodes without bonds in place.
void StaticEquilibrium::hold_lonely_nodes() {
  const auto degree = degrees(lattice_->grid, lattice_->family, state_->bonds);
  for (int j = 0; j < lattice_->grid.ny; ++j)
    for (int i = 0; i < lattice_->grid.nx; ++i) {
      if (degree[lattice_->grid.index(i, j)] != 0) continue;
      const auto at = static_cast<std::size_t>(net_.layout().at(i, j));
      mobile_.x[at] = mobile_.y[at] = load_.x[at] = load_.y[at] = 0.0;
    }
}

Fragments StaticEquilibrium::fragments() const {
  std::vector<Hold> holds;
  for (const RigidContacts::Spring& spring : contacts_.holds(u_))
    holds.push_back({spring.i, spring.j, spring.outward});
  return {*lattice_, *state_, mobile_, net_.threads(), holds};
}

void StaticEquilibrium::touch() {
  if (contacts_.bodies().empty()) return;
  const std::size_t before = contacts_.springs().size();
  contacts_.find(u_);
  touches_others_ |= contacts_.springs().size() != before;
  push_ = NodeVectors(net_.layout());
  contacts_.add_pushes(push_);
}

NodeVectors StaticEquilibrium::all_loads() const {
  NodeVectors sum = load_;
  contacts_.add_pushes(sum);
  return sum;
}

// The forces follow when they are known.
void StaticEquilibrium::set_out() {
  before_ = {u_, {}, all_loads()};
}

void StaticEquilibrium::lose(const std::vector<BrokenBond>& broken_bonds) {
  net_.forget(broken_bonds);
  fragments_ = fragments();
  hold_lonely_nodes();
  max_left_ = 0.0;
  set_out();
}

void StaticEquilibrium::comes_from(const std::vector<LoadedNode>& loads,
                                   const RigidContacts& contacts, std::span<const double> heat) {
  before_.load = NodeVectors(net_.layout());
  take_loads(loads, before_.load);
  contacts.add_pushes(before_.load);
  if (heat.empty()) return;
  before_.pull = NodeVectors(net_.layout());
  LinearisedBonds(*lattice_, *state_, net_.threads(), heat).forces(before_.u, before_.pull);
}

void StaticEquilibrium::take_loads(const std::vector<LoadedNode>& forces, NodeVectors& load) const {
  for (const LoadedNode& node : forces) {
    const auto at = static_cast<std::size_t>(net_.layout().at(node.i, node.j));
    const Vec2 force = (node.inertia * lattice_->rho / net_.unit_of_force()) * node.acceleration;
    load.x[at] = force.x();
    load.y[at] = force.y();
  }
}

void StaticEquilibrium::take_prescribed(const std::vector<PrescribedNode>& prescribed) {
  for (const PrescribedNode& node : prescribed) {
    const auto at = static_cast<std::size_t>(net_.layout().at(node.i, node.j));
    if (node.along_x) move_.x[at] = node.move.x();
    if (node.along_y) move_.y[at] = node.move.y();
    is_prescribed_ |= move_.x[at] != 0.0 || move_.y[at] != 0.0;
  }
}

void StaticEquilibrium::refuse(const Fragment& fragment, const Resultant& resultant,
                               const std::string& who) const {
  const Grid& grid = lattice_->grid;
  const double unit = net_.unit_of_force() * grid.dx * grid.dx;  // N/m
  const Vec2 force = unit * resultant.force, centre = grid.centre + grid.dx * fragment.centre;
  throw Error(
      ErrorKind::refused,
      fmt::format("{}: the loads push the fragment of {} nodes around ({}, {}) with ({}, {}) and "
                  "turn it with {}, and {}",
                  who, fragment.nodes, quantity(centre.x(), "m"), quantity(centre.y(), "m"),
                  quantity(force.x(), "N/m"), quantity(force.y(), "N/m"),
                  quantity(unit * grid.dx * resultant.moment, "N"),
                  fragment.is_held ? "its supports give way" : "nothing holds it"),
      "balance the loads, or hold it by a support");
}

// A force shared by all nodes may be within the tolerance of each, so its resultant is checked.
void StaticEquilibrium::check_held(const NodeVectors& load, double largest,
                                   const RelaxOptions& options) const {
  for (std::size_t k = 0; k < fragments_.list().size(); ++k) {
    const Fragment& fragment = fragments_.list()[k];
    if (fragment.motions.empty()) continue;
    const Resultant resultant = fragments_.resultant(k, load, u_);
    const double max = options.tolerance * largest * fragment.nodes;
    for (const RigidMotion& motion : fragment.motions) {
      // Moments on a free fragment are balanced by rotating it, if possible.
      const double moment = fragment.is_held ? resultant.moment : 0.0;
      if (std::abs(motion.shift.dot(resultant.force) + motion.turn * moment) > max)
        refuse(fragment, resultant, options.who);
    }
  }
}

// Loads keep their direction: on a deformed fragment they have a moment, under which it rotates
// until there is none, tan(angle) = moment/virial.
bool StaticEquilibrium::turn_free_fragments(const RelaxOptions& options) {
  constexpr double steepest = 0.2;
  bool turned = false;
  for (std::size_t k = 0; k < fragments_.list().size(); ++k) {
    const Fragment& fragment = fragments_.list()[k];
    if (fragment.is_held) continue;
    const Resultant resultant = fragments_.resultant(k, load_, u_);
    const double radius = std::sqrt(fragment.inertia / fragment.nodes);
    if (std::abs(resultant.moment) <=
        0.1 * options.tolerance * largest_load_ * fragment.nodes * radius)
      continue;
    if (std::abs(resultant.moment) > steepest * std::abs(resultant.virial))
      refuse(fragment, resultant, options.who);
    fragments_.turn(k, std::atan(resultant.moment / resultant.virial), u_);
    turned = true;
  }
  return turned;
}

double StaticEquilibrium::stiffest() const {
  double max = 0.0;
  for (const MaterialOnLattice& entry : lattice_->materials)
    max = std::max(max, entry.calibration.c / lattice_->calibration.c);
  double sum = 0.0;
  lattice_->family.for_each_bond(
      [&](int, int, const Vec2& xi, double weight, int) { sum += 2.0 * weight / xi.norm(); });
  return (lattice_->surface.empty() ? 1.0 : most_surface_factor) * max * sum;
}

StaticEquilibrium::Balance StaticEquilibrium::find_left() {
  const NodeLayout& layout = net_.layout();
  net_.forces(u_, pull_);
  touch();
  Balance balance{0.0, 0.0, largest_load_, 0.0};
  std::vector<double> squares(static_cast<std::size_t>(layout.ny));
  double farthest = 0.0;
  for (int j = 0; j < layout.ny; ++j) {
    for (int i = 0; i < layout.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout.at(i, j));
      const Vec2 sum(pull_.x[at] + (load_.x[at] + push_.x[at]),
                     pull_.y[at] + (load_.y[at] + push_.y[at]));
      residual_.x[at] = mobile_.x[at] * sum.x();
      residual_.y[at] = mobile_.y[at] * sum.y();
      const Vec2 reaction(sum.x() - residual_.x[at], sum.y() - residual_.y[at]);
      const Vec2 push(push_.x[at], push_.y[at]);
      balance.reference = std::max({balance.reference, reaction.norm(), push.norm()});
    }
    farthest = std::max(farthest, largest_of_row(layout, u_, j));
  }
  if (fragments_.list().size() > 0) fragments_.take_out_rigid(residual_);
  std::vector<double> max(squares.size());
  for (int j = 0; j < layout.ny; ++j) {
    squares[static_cast<std::size_t>(j)] = dot_of_row(layout, residual_, residual_, j);
    max[static_cast<std::size_t>(j)] = largest_of_row(layout, residual_, j);
  }
  balance.largest = max_of_rows(max);
  balance.total = std::sqrt(sum_of_rows(squares));
  // Rounding error of displacement differences, summed over a node's bonds.
  balance.rounding =
      8.0 * std::numeric_limits<double>::epsilon() * stiffest() * farthest + contacts_.rounding();
  return balance;
}

// Takes a Newton step, halved while it increases the residual. Returns false if no part of it
// helps.
bool StaticEquilibrium::improve(const NodeVectors& step, Balance& balance) {
  const NodeVectors from = u_;
  const double before = balance.total;
  double share = 1.0;
  for (int halving = 0; halving <= max_halvings; ++halving, share *= 0.5) {
    for (std::size_t at = 0; at < u_.x.size(); ++at) {
      u_.x[at] = from.x[at] + share * step.x[at];
      u_.y[at] = from.y[at] + share * step.y[at];
    }
    balance = find_left();
    // Prescribed displacements must be reached in this step; later steps reduce the residual.
    if (balance.total < before || (is_prescribed_ && std::isfinite(balance.total))) return true;
    if (is_prescribed_) return false;
  }
  u_ = from;
  balance = find_left();
  return false;
}

// Compression can make the exact tangent lose its sign, on the way to an equilibrium or in it. From
// then on the positive tangent is used, which converges more slowly.
bool StaticEquilibrium::take_tangent() {
  if (stale_) net_.linearise(u_, tangent_);
  stale_ = false;
  if (touches_others_) coarse_.reset();
  touches_others_ = false;
  if (!coarse_) {
    coarse_ = std::make_unique<CoarseSpace>(net_, mobile_, &contacts_);
    iterations_then_ = 0;
  }
  return coarse_->is_positive() || tangent_ == Tangent::positive;
}

NodeVectors StaticEquilibrium::newton_step(double goal, const RelaxOptions& options,
                                           RelaxResult& result) {
  int iterations = result.iterations;
  const auto look = [&](double left) {
    ++iterations;
    if (interrupted())
      throw Error(ErrorKind::interrupted,
                  fmt::format("{}: interrupted, the plate is {}", options.who, options.left));
    max_left_ = std::max(max_left_, left);
    if (!options.progress || !(goal > 0.0)) return;
    const double way = std::log(max_left_ / goal);
    const double rest = std::log(std::max(left / goal, 1.0));
    options.progress(way > 0.0 ? 1.0 - rest / way : 1.0, iterations);
  };
  const int max = 2000 + 40 * (net_.layout().nx + net_.layout().ny);
  ++result.newton_steps;
  for (;; tangent_ = Tangent::positive, stale_ = true, coarse_.reset()) {
    if (!take_tangent()) continue;
    ConjugateGradient conjugate_gradients(
        net_, fragments_, mobile_, coarse_->is_positive() ? coarse_.get() : nullptr, &contacts_);
    NodeVectors step = move_;
    const ConjugateGradient::Outcome outcome =
        conjugate_gradients.solve(residual_, step, share_of_step, 0.3 * goal, max, look);
    result.iterations += outcome.iterations;
    if (!outcome.is_positive && tangent_ == Tangent::exact) continue;
    if (iterations_then_ == 0) iterations_then_ = outcome.iterations;
    if (outcome.iterations > 2 * iterations_then_ + few_iterations) coarse_.reset();
    return step;
  }
}

StaticWork StaticEquilibrium::work_done() const {
  return work_between(net_.layout(), before_, {u_, pull_, all_loads()}, mobile_);
}

Equilibrium StaticEquilibrium::solve(const RelaxOptions& options) {
  const bool is_touched = !contacts_.bodies().empty();
  if (!is_touched) check_held(load_, largest_load_, options);
  Balance balance = find_left();
  if (before_.pull.x.empty()) before_.pull = pull_;
  if (turn_free_fragments(options)) balance = find_left();
  const double first = largest_load_ > 0.0 || is_prescribed_ ? 0.0 : balance.largest;
  Equilibrium rest;
  for (;;) {
    const double reference = std::max(balance.reference, first);
    const double goal = std::max(options.tolerance * reference, balance.rounding);
    rest.result.residual = reference > 0.0 ? balance.largest / reference : 0.0;
    if (balance.largest <= goal && !is_prescribed_) break;
    if (rest.result.newton_steps == max_newton_steps || !std::isfinite(balance.largest))
      fail(rest.result, options.who);
    const bool fresh = stale_;
    const double before = balance.largest;
    if (!improve(newton_step(goal, options, rest.result), balance)) {
      if (balance.largest <= 100.0 * balance.rounding) break;
      if (fresh || is_prescribed_) fail(rest.result, options.who);
    }
    stale_ = is_prescribed_ || balance.largest > max_for_old_tangent * before;
    is_prescribed_ = false;
    move_ = NodeVectors(net_.layout());
    if (turn_free_fragments(options)) balance = find_left();
  }
  if (is_touched) check_held(all_loads(), balance.reference, options);
  Stretches stretches = net_.stretches(u_);
  rest.result.max = stretches.max;
  rest.result.beyond = std::ssize(stretches.beyond);
  rest.beyond = std::move(stretches.beyond);
  rest.work = work_done();
  rest.u = u_;
  return rest;
}

}  // namespace hackle
