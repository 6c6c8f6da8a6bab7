// SPDX-License-Identifier: MIT
#include "solver/terms/impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/units.hpp"
#include "lattice/carve.hpp"
#include "scene/load_names.hpp"
#include "solver/order_free_sum.hpp"
#include "solver/terms/cell_overlap.hpp"
#include "solver/terms/forces.hpp"
#include "solver/terms/makers.hpp"
#include "solver/terms/roughness.hpp"

namespace hackle {
namespace {

template <class Visit>
void for_solid_nodes(const Lattice& lattice, const Visit& visit) {
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i)
      if (!lattice.is_void(i, j)) visit(i, j);
}

// A disc lighter than the nodes it pushes at once would be thrown back faster than it came.
void check(const Impactor& impactor, const Lattice& lattice, Problems& problems) {
  const double dx = lattice.grid.dx, min_mass = 2.0 * impactor.radius * dx * lattice.rho;
  if (impactor.radius < dx)
    problems.add(fmt::format("impactor: its radius of {} is under one spacing of {}",
                             quantity(impactor.radius, "m"), quantity(dx, "m")),
                 "take a larger disc or a finer spacing");
  else if (impactor.mass < min_mass)
    problems.add(fmt::format("impactor: its mass of {} is less than that of the nodes it pushes",
                             quantity(impactor.mass, "kg/m")),
                 fmt::format("give at least {}", quantity(min_mass, "kg/m")));
}

}  // namespace

Impact::Impact(const Plate& plate, const Lattice& lattice, double dt)
    : dt_(dt), strength_(strength_of_push(plate, lattice, dt)) {
  const double dx = lattice.grid.dx;
  Problems problems;
  for (const Impactor& impactor : plate.loads.impactors) {
    check(impactor, lattice, problems);
    discs_.push_back(
        {impactor, impactor.radius / dx, impactor.mass / (lattice.rho * dx * dx), {0, 0}, {}, {}});
  }
  problems.throw_if_any();
}

Disc Impact::start_of(const RigidDisc& disc, const Lattice& lattice) const {
  return {lattice.grid.from_centre(disc.impactor.centre),
          disc.impactor.velocity * (dt_ / lattice.grid.dx)};
}

std::unique_ptr<Term> make_impact(const Plate& plate, const Lattice& lattice, double dt) {
  return plate.loads.impactors.empty() ? nullptr : std::make_unique<Impact>(plate, lattice, dt);
}

void Impact::begin(const Surroundings& around, State& state) {
  const Lattice& lattice = around.lattice;
  watch_again_ = state.step;
  for (std::size_t k = state.discs.size(); k < discs_.size(); ++k)
    check_start(discs_[k], start_of(discs_[k], lattice), lattice, state);
  for (std::size_t k = state.discs.size(); k < discs_.size(); ++k)
    state.discs.push_back(start_of(discs_[k], lattice));
}

void Impact::check_start(const RigidDisc& disc, const Disc& place, const Lattice& lattice,
                         const State& state) const {
  const Grid& grid = lattice.grid;
  double nearest = std::numeric_limits<double>::max();
  for_solid_nodes(lattice, [&](int i, int j) {
    nearest = std::min(nearest, way_to_cell(place_now(grid, state, i, j), place.centre).norm());
  });
  if (nearest > disc.radius - tie) return;
  throw Error(ErrorKind::refused,
              fmt::format("impactor: at its start it overlaps the plate by {}",
                          quantity((disc.radius - nearest) * grid.dx, "m")),
              "let it start beside the plate or in a hole");
}

// Valid until a node could have crossed the watched margin, if no speed doubles. If one does, the
// node is found a little later.
void Impact::watch(const Lattice& lattice, const State& state) {
  double fastest = 0.0, fastest_disc = 0.0;
  for (std::size_t k = 0; k < discs_.size(); ++k) {
    discs_[k].near.clear();
    fastest_disc = std::max(fastest_disc, state.discs[k].velocity.norm());
  }
  for_solid_nodes(lattice, [&](int i, int j) {
    const Vec2 place = place_now(lattice.grid, state, i, j);
    fastest = std::max(fastest, state.v(i, j).norm());
    for (std::size_t k = 0; k < discs_.size(); ++k)
      if (way_to_cell(place, state.discs[k].centre).norm() < discs_[k].radius + watched)
        discs_[k].near.push_back(lattice.grid.index(i, j));
  });
  const double approach = 2.0 * (fastest + fastest_disc);
  const double steps = approach > 0.0 ? watched / approach : 1.0;
  watch_again_ = state.step + static_cast<std::int64_t>(std::clamp(steps, 1.0, 64.0));
}

// Returns whether something touches, or did in the last step.
bool Impact::update(const Surroundings& around, State& state) {
  const Lattice& lattice = around.lattice;
  const bool touched = !forces_.empty();
  if (state.step >= watch_again_) watch(lattice, state);
  forces_.clear();
  for (std::size_t k = 0; k < discs_.size(); ++k)
    forces_ = sum_of(forces_, push(discs_[k], state.discs[k], lattice, state), lattice.grid);
  return touched || !forces_.empty();
}

std::vector<LoadedNode> Impact::push(RigidDisc& disc, const Disc& place, const Lattice& lattice,
                                     const State& state) const {
  const Grid& grid = lattice.grid;
  const Roughness roughness{disc.impactor.friction, disc.impactor.restitution};
  const double unit = grid.dx / (dt_ * dt_);
  std::vector<LoadedNode> pushed;
  OrderFreeSum back;
  disc.push_on_nodes = {};
  for (const std::size_t node : disc.near) {
    const auto columns = static_cast<std::size_t>(grid.nx);
    const int i = static_cast<int>(node % columns), j = static_cast<int>(node / columns);
    const Vec2 at = place_now(grid, state, i, j), way = way_to_cell(at, place.centre);
    const double r = way.norm();
    if (!(r < disc.radius && r > 0.0)) continue;
    const double strength = strength_ * lattice.micromodulus_at(i, j) / lattice.calibration.c;
    const double inertia = lattice.material_at(i, j).material.rho / lattice.rho;
    Vec2 force = (strength * (disc.radius - r) / r) * way;
    if (!roughness.is_smooth())
      force += loss_of(roughness, force, state.v(i, j) - place.velocity, hold_of_body * inertia);
    pushed.push_back({i, j, force * (unit / inertia), inertia});
    back.subtract(force);
    disc.push_on_nodes.add(at, -force);
  }
  disc.push = back.value();
  return pushed;
}

void Impact::follow(const Surroundings&, State& state) {
  for (std::size_t k = 0; k < discs_.size(); ++k) {
    Disc& disc = state.discs[k];
    disc.velocity += discs_[k].push / discs_[k].mass;
    disc.centre += disc.velocity;
  }
}

void Impact::add_work(const Surroundings& around, const State& state, WorkOf part,
                      double& work) const {
  add_work_of(forces_, around, state, part, work);
}

void Impact::add_reactions(const Surroundings& around, const State& state,
                           std::vector<Reaction>& list) const {
  const Grid& grid = around.lattice.grid;
  const double unit = around.energy_unit() / grid.dx;
  for (std::size_t k = 0; k < discs_.size(); ++k) {
    const RigidDisc& disc = discs_[k];
    const int number = static_cast<int>(k) + 1;
    Reaction reaction = disc.push_on_nodes.reaction(
        load_name(disc.impactor.name, "impactor", number), "impactor", number, grid, unit);
    reaction.centre = grid.centre + grid.dx * state.discs[k].centre;
    reaction.force = unit * disc.push;
    reaction.moved = reaction.centre - disc.impactor.centre;
    list.push_back(std::move(reaction));
  }
}

void Impact::check_rest(const std::string& who) const {
  throw Error(ErrorKind::refused,
              fmt::format("{}: a plate that is being hit cannot be brought to rest", who),
              "bring it to rest before s:impactor{}, or let damping calm it");
}

}  // namespace hackle
