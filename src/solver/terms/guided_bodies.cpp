// SPDX-License-Identifier: MIT
#include "solver/terms/guided_bodies.hpp"

#include <algorithm>
#include <utility>

#include "scene/load_names.hpp"
#include "solver/order_free_sum.hpp"
#include "solver/terms/cell_overlap.hpp"
#include "solver/terms/forces.hpp"
#include "solver/terms/makers.hpp"

namespace hackle {

GuidedBodies::GuidedBodies(const Plate& plate, const Lattice& lattice, double dt)
    : rollers_(plate.loads.rollers.size()),
      strength_(strength_of_push(plate, lattice, dt)),
      bodies_(guided_bodies(plate, lattice, dt)),
      touch_(bodies_.size()) {
}

std::unique_ptr<Term> make_guided_bodies(const Plate& plate, const Lattice& lattice, double dt) {
  if (plate.loads.rollers.empty() && plate.loads.platens.empty()) return nullptr;
  return std::make_unique<GuidedBodies>(plate, lattice, dt);
}

void GuidedBodies::tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt) {
  for (GuidedBody& body : bodies_) body.tabulate(clock, begin, end, dt);
}

void GuidedBodies::add_work(const Surroundings& around, const State& state, WorkOf part,
                            double& work) const {
  add_work_of(forces_, around, state, part, work);
}

void GuidedBodies::begin(const Surroundings& around, State& state) {
  watch_again_ = state.step;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    std::vector<Disc>& places = k < rollers_ ? state.rollers : state.platens;
    if (places.size() <= (k < rollers_ ? k : k - rollers_))
      places.push_back(bodies_[k].start_of(state.clock, state.step, around.dt));
  }
  lead(around.dt, state);
}

// Bodies whose place is a function of time.
void GuidedBodies::lead(double dt, State& state) const {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (bodies_[k].is_pressed()) continue;
    const auto centre = [&](std::int64_t step) { return bodies_[k].centre(state.clock, step, dt); };
    const Vec2 now = centre(state.step);
    place(state, k) = {now, state.step == 0 ? Vec2(0, 0) : Vec2(now - centre(state.step - 1))};
  }
}

// What a force leads is accelerated along it by what acted at the beginning of the step.
void GuidedBodies::follow(const Surroundings& around, State& state) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const GuidedBody& body = bodies_[k];
    if (!body.is_pressed()) continue;
    const Vec2 acting = body.force(state.clock, state.step - 1, around.dt) + touch_[k].push;
    Disc& moved = place(state, k);
    moved.velocity += acting.dot(body.along()) / body.mass * body.along();
    moved.centre += moved.velocity;
  }
  lead(around.dt, state);
}

bool GuidedBodies::update(const Surroundings& around, State& state) {
  const bool touched = !forces_.empty();
  if (state.step >= watch_again_) watch(around, state);
  forces_.clear();
  for (std::size_t k = 0; k < bodies_.size(); ++k)
    forces_ = sum_of(forces_, push(k, around, state), around.lattice.grid);
  return touched || !forces_.empty();
}

// Valid until a node could have crossed the watched margin, if no speed doubles. If one does, the
// node is found a little later.
void GuidedBodies::watch(const Surroundings& around, const State& state) {
  const Grid& grid = around.lattice.grid;
  double fastest = 0.0, fastest_body = 0.0;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    touch_[k].near.clear();
    fastest_body = std::max(fastest_body, place(state, k).velocity.norm());
  }
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (around.lattice.is_void(i, j)) continue;
      fastest = std::max(fastest, state.v(i, j).norm());
      const Vec2 node = place_now(grid, state, i, j);
      for (std::size_t k = 0; k < bodies_.size(); ++k)
        if (!bodies_[k].overlap(node, place(state, k).centre, watched).isZero(0.0))
          touch_[k].near.push_back(grid.index(i, j));
    }
  const double approach = 2.0 * (fastest + fastest_body);
  const double steps = approach > 0.0 ? watched / approach : 1.0;
  watch_again_ = state.step + static_cast<std::int64_t>(std::clamp(steps, 1.0, 16.0));
}

std::vector<LoadedNode> GuidedBodies::push(std::size_t k, const Surroundings& around,
                                           const State& state) {
  const Lattice& lattice = around.lattice;
  const Grid& grid = lattice.grid;
  const double unit = grid.dx / (around.dt * around.dt);
  const GuidedBody& body = bodies_[k];
  const Disc& at = place(state, k);
  std::vector<LoadedNode> pushed;
  OrderFreeSum back;
  touch_[k].push_on_nodes = {};
  for (const std::size_t node : touch_[k].near) {
    const auto columns = static_cast<std::size_t>(grid.nx);
    const int i = static_cast<int>(node % columns), j = static_cast<int>(node / columns);
    const Vec2 here = place_now(grid, state, i, j), overlap = body.overlap(here, at.centre);
    if (overlap.isZero(0.0)) continue;
    const double inertia = lattice.material_at(i, j).material.rho / lattice.rho;
    Vec2 force = strength_ * lattice.micromodulus_at(i, j) / lattice.calibration.c * overlap;
    force += loss_of(body.roughness, force, state.v(i, j) - at.velocity, hold_of_body * inertia);
    pushed.push_back({i, j, force * (unit / inertia), inertia});
    back.subtract(force);
    touch_[k].push_on_nodes.add(here, -force);
  }
  touch_[k].push = back.value();
  return pushed;
}

void GuidedBodies::add_reactions(const Surroundings& around, const State& state,
                                 std::vector<Reaction>& list) const {
  const Grid& grid = around.lattice.grid;
  const double unit = around.energy_unit() / grid.dx;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const GuidedBody& body = bodies_[k];
    const int number = static_cast<int>(k < rollers_ ? k : k - rollers_) + 1;
    Reaction reaction = touch_[k].push_on_nodes.reaction(load_name(body.name, body.who, number),
                                                         body.who, number, grid, unit);
    reaction.centre = grid.centre + grid.dx * place(state, k).centre;
    reaction.force = unit * touch_[k].push;
    reaction.moved = grid.dx * (place(state, k).centre - body.start);
    list.push_back(std::move(reaction));
  }
}

// Forces on bodies become those on nodes: rho dx^3/dt^2 over the area of a node, in c dx^2.
RestingBodies GuidedBodies::placed(const Lattice& lattice, const State& state, double dt) const {
  const double unit = lattice.rho / (lattice.calibration.c * lattice.grid.dx * dt * dt);
  RestingBodies resting{{}, unit * strength_};
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const GuidedBody& body = bodies_[k];
    const double force =
        body.is_pressed() ? unit * body.force(state.clock, state.step, dt).dot(body.along()) : 0.0;
    resting.list.push_back({body, place(state, k).centre, force});
  }
  return resting;
}

RestingBodies GuidedBodies::led(const Lattice& lattice, const State& state, double dt) const {
  RestingBodies resting = placed(lattice, state, dt);
  for (RestingBody& one : resting.list)
    if (!one.body.is_pressed()) one.centre = one.body.centre(state.clock, state.step, dt);
  return resting;
}

void GuidedBodies::stand(const std::vector<RestingBody>& bodies, State& state) const {
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (bodies[k].body.is_pressed()) place(state, k) = {bodies[k].centre, {0, 0}};
}

}  // namespace hackle
