// SPDX-License-Identifier: MIT
#include "solver/contact_forces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace hackle {
namespace {

constexpr double farthest = 1.5;  // spacings: pairs that are farther apart at rest count as so far
constexpr double slack = 0.25;    // how far nodes may wander before pairs are sought anew
constexpr double cell = farthest + 2.0 * slack;

// Far beyond any plate, nodes of a diverged solution share their cells.
std::int64_t column_of(double place) {
  constexpr double most = 1e9;
  return static_cast<std::int64_t>(std::abs(place) < most ? std::floor(place / cell) : most);
}

std::int64_t cell_at(const Vec2& place, int right, int up) {
  return ((column_of(place.y()) + up) << 32) + column_of(place.x()) + right;
}

}  // namespace

ContactForces::ContactForces(const Contact& contact, const Lattice& lattice, double dt)
    : reach_(contact.reach),
      strength_(contact.stiffness * lattice.calibration.c * lattice.grid.dx * dt * dt /
                (lattice.rho * lattice.family.m())),
      unit_(lattice.grid.dx / (dt * dt)) {
}

void ContactForces::begin(const Lattice& lattice, const State& state) {
  const Grid& grid = lattice.grid;
  is_open_.assign(grid.nodes(), 0);
  open_.clear();
  const auto degree = degrees(grid, lattice.family, state.bonds);
  cells_.clear();
  pairs_.clear();
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (degree[grid.index(i, j)] < lattice.family.bonds()) open(lattice, state, i, j);
}

void ContactForces::take_note(const Lattice& lattice, const State& state,
                              std::span<const Loss> losses) {
  const NodeLayout layout = lattice.grid.layout();
  for (const Loss& loss : losses) {
    const auto j = static_cast<int>(loss.at / layout.stride());
    const auto i = static_cast<int>(loss.at - layout.at(0, j));
    const int lost = 32 * loss.word + std::countr_zero(loss.bit);
    open(lattice, state, i, j);
    lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
      if (bit == lost) open(lattice, state, i + a, j + b);
    });
  }
}

void ContactForces::open(const Lattice& lattice, const State& state, int i, int j) {
  const Grid& grid = lattice.grid;
  if (lattice.is_void(i, j) || is_open_[grid.index(i, j)] != 0) return;
  is_open_[grid.index(i, j)] = 1;
  const Vec2 u = state.u(i, j);
  open_.push_back({i, j, grid.from_centre(i, j) + u, u, {}});
  find_pairs(static_cast<int>(open_.size()) - 1, lattice);
}

// With all nodes in the cells around it, and into its own.
void ContactForces::find_pairs(int node, const Lattice& lattice) {
  const Vec2 home = open_[static_cast<std::size_t>(node)].home;
  for (int up = -1; up <= 1; ++up)
    for (int right = -1; right <= 1; ++right) {
      const auto found = cells_.find(cell_at(home, right, up));
      if (found == cells_.end()) continue;
      for (const int other : found->second) {
        const Pair pair = pair_of(node, other, lattice);
        const Vec2 apart = open_[static_cast<std::size_t>(other)].home - home;
        if (apart.norm() < pair.distance + 2.0 * slack) pairs_.push_back(pair);
      }
    }
  cells_[cell_at(home, 0, 0)].push_back(node);
}

ContactForces::Pair ContactForces::pair_of(int one, int other, const Lattice& lattice) const {
  const Open& p = open_[static_cast<std::size_t>(one)];
  const Open& q = open_[static_cast<std::size_t>(other)];
  const int columns = q.i - p.i, rows = q.j - p.j;
  Pair pair{one, other, reach_ * std::min(std::hypot(columns, rows), farthest), 0.0, -1, 0};
  const double c = 0.5 * (lattice.micromodulus_at(p.i, p.j) + lattice.micromodulus_at(q.i, q.j));
  pair.strength = strength_ * c / lattice.calibration.c;
  lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
    const bool kept = a == columns && b == rows;
    if (!kept && !(a == -columns && b == -rows)) return;
    const Open& keeper = kept ? p : q;
    pair.at = lattice.grid.layout().at(keeper.i, keeper.j);
    pair.bit = bit;
  });
  return pair;
}

bool ContactForces::follow(const Grid& grid, const State& state) {
  bool near = true;
  for (Open& node : open_) {
    node.u = state.u(node.i, node.j);
    node.force = {};
    near &= (grid.from_centre(node.i, node.j) + node.u - node.home).norm() < slack;
  }
  return near;
}

void ContactForces::renew(const Lattice& lattice, const State& state) {
  cells_.clear();
  pairs_.clear();
  for (int node = 0; node < static_cast<int>(open_.size()); ++node) {
    Open& own = open_[static_cast<std::size_t>(node)];
    own.home = lattice.grid.from_centre(own.i, own.j) + state.u(own.i, own.j);
    find_pairs(node, lattice);
  }
}

void ContactForces::update(const Lattice& lattice, const State& state) {
  if (!follow(lattice.grid, state)) renew(lattice, state);
  OrderFreeSum energy;
  for (const Pair& pair : pairs_) energy.add({push(pair, state.bonds), 0.0});
  energy_ = energy.value().x();
  collect(lattice);
}

double ContactForces::push(const Pair& pair, const BondBits& bonds) {
  Open& p = open_[static_cast<std::size_t>(pair.one)];
  Open& q = open_[static_cast<std::size_t>(pair.other)];
  const Vec2 apart = Vec2(q.i - p.i, q.j - p.j) + (q.u - p.u);
  const double r = apart.norm();
  if (!(r < pair.distance && r > 0.0) || (pair.at >= 0 && bonds.holds(pair.at, pair.bit)))
    return 0.0;
  const double overlap = pair.distance - r;
  const Vec2 force = (pair.strength * overlap / r) * apart;
  q.force.add(force);
  p.force.subtract(force);
  return 0.5 * pair.strength * overlap * overlap;
}

void ContactForces::collect(const Lattice& lattice) {
  forces_.clear();
  for (const Open& node : open_) {
    if (node.force.is_zero()) continue;
    const double inertia = lattice.material_at(node.i, node.j).material.rho / lattice.rho;
    forces_.push_back({node.i, node.j, node.force.value() * (unit_ / inertia), inertia});
  }
  std::ranges::sort(forces_, {},
                    [&](const LoadedNode& load) { return lattice.grid.index(load.i, load.j); });
}

}  // namespace hackle
