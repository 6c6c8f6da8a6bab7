// SPDX-License-Identifier: MIT
#include "solver/terms/contact_forces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "solver/terms/makers.hpp"

namespace hackle {
namespace {

constexpr double farthest = 1.5;  // spacings: the initial distance of pairs counts as at most this
constexpr double slack = 0.35;    // how far nodes may move before pairs are found again
// The share of its sliding velocity that friction between two nodes may take in a step; a node has
// up to four contacts, and both ends of each move (src/lattice/README.md 4.7).
constexpr double hold_of_pair = 1.0 / 16.0;
constexpr double cell = farthest + 2.0 * slack;

// Nodes of a diverged solution, far beyond any plate, share their cells.
std::int64_t column_of(double place) {
  constexpr double max = 1e9;
  return static_cast<std::int64_t>(std::abs(place) < max ? std::floor(place / cell) : max);
}

std::int64_t cell_at(const Vec2& place, int right, int up) {
  return ((column_of(place.y()) + up) << 32) + column_of(place.x()) + right;
}

}  // namespace

ContactForces::ContactForces(const Contact& contact, const Lattice& lattice, double dt)
    : faces_(lattice, dt),
      roughness_{contact.friction, contact.restitution},
      reach_(contact.reach),
      strength_(contact.stiffness * lattice.calibration.c * lattice.grid.dx * dt * dt /
                (lattice.rho * lattice.family.m())),
      unit_(lattice.grid.dx / (dt * dt)) {
}

std::unique_ptr<Term> make_contact(const Plate& plate, const Lattice& lattice, double dt) {
  return plate.contact ? std::make_unique<ContactForces>(*plate.contact, lattice, dt) : nullptr;
}

void ContactForces::begin(const Surroundings& around, State& state) {
  const Lattice& lattice = around.lattice;
  const Grid& grid = lattice.grid;
  place_.assign(grid.nodes(), -1);
  open_.clear();
  cells_.clear();
  pairs_.clear();
  faces_.clear();
  stored_before_.reset();
  const auto degree = degrees(grid, lattice.family, state.bonds);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (degree[grid.index(i, j)] < lattice.family.bonds() && !lattice.is_void(i, j))
        open(lattice, state, i, j);
  for (const KeptBond& bond : lattice.cut) lose(lattice, state, bond.i, bond.j, bond.bit);
  for_each_missing(lattice.bonds, state.bonds, lattice,
                   [&](const KeptBond& bond) { lose(lattice, state, bond.i, bond.j, bond.bit); });
  faces_.find_near(open_, slack);
}

// Pairs nodes that are new among the open ones with all others, and the open ends of the new lost
// bonds with each other.
void ContactForces::follow(const Surroundings& around, State& state) {
  const Lattice& lattice = around.lattice;
  const std::vector<BrokenBond>& broken_bonds = around.stepper.broken_bonds();
  if (broken_bonds.empty()) return;
  move_nodes(lattice.grid, state);
  stored_before_ = faces_.energy(open_, around.heat);
  const NodeLayout layout = lattice.grid.layout();
  const int open_before = static_cast<int>(open_.size());
  for (const BrokenBond& broken : broken_bonds) {
    const auto j = static_cast<int>(broken.at / layout.stride());
    const auto i = static_cast<int>(broken.at - layout.at(0, j));
    const Pair pair = lose(lattice, state, i, j, 32 * broken.word + std::countr_zero(broken.bit));
    if (std::max(pair.one, pair.other) < open_before) pair_up(pair.one, pair.other, lattice);
  }
}

ContactForces::Pair ContactForces::lose(const Lattice& lattice, const State& state, int i, int j,
                                        int bit) {
  const auto [columns, rows] = faces_.way(bit);
  const int one = open(lattice, state, i, j);
  const int other = open(lattice, state, i + columns, j + rows);
  faces_.lose(lattice, open_, one, other, bit);
  return {one, other};
}

// Returns the index of the node in open_.
int ContactForces::open(const Lattice& lattice, const State& state, int i, int j) {
  const Grid& grid = lattice.grid;
  int& place = place_[grid.index(i, j)];
  if (place >= 0) return place;
  place = static_cast<int>(open_.size());
  const Vec2 u = state.u(i, j);
  open_.push_back({i,
                   j,
                   grid.index(i, j),
                   grid.from_centre(i, j) + u,
                   u,
                   {},
                   lattice.material_at(i, j).material.rho / lattice.rho});
  find_pairs(place, lattice, state.bonds);
  return place;
}

// Pairs a node with all nodes in the neighbouring cells, and adds it to its own cell.
void ContactForces::find_pairs(int node, const Lattice& lattice, const BondBits& bonds) {
  const OpenNode& own = open_[static_cast<std::size_t>(node)];
  for (int up = -1; up <= 1; ++up)
    for (int right = -1; right <= 1; ++right) {
      const auto found = cells_.find(cell_at(own.home, right, up));
      if (found == cells_.end()) continue;
      for (const int index : found->second) {
        const OpenNode& other = open_[static_cast<std::size_t>(index)];
        if ((other.home - own.home).norm() < farthest + 2.0 * slack &&
            !holds(lattice.grid, lattice.family, bonds, own.i, own.j, other.i - own.i,
                   other.j - own.j))
          pair_up(node, index, lattice);
      }
    }
  cells_[cell_at(own.home, 0, 0)].push_back(node);
}

void ContactForces::pair_up(int one, int other, const Lattice& lattice) {
  const OpenNode& p = open_[static_cast<std::size_t>(one)];
  const OpenNode& q = open_[static_cast<std::size_t>(other)];
  const double distance = reach_ * std::min(std::hypot(q.i - p.i, q.j - p.j), farthest);
  if ((q.home - p.home).norm() >= distance + 2.0 * slack) return;
  const double c = 0.5 * (lattice.micromodulus_at(p.i, p.j) + lattice.micromodulus_at(q.i, q.j));
  pairs_.push_back({one, other, distance, strength_ * c / lattice.calibration.c});
}

bool ContactForces::move_nodes(const Grid& grid, const State& state) {
  bool near = true;
  for (OpenNode& node : open_) {
    node.u = state.u(node.i, node.j);
    node.force = {};
    node.loss = {};
    if (!roughness_.is_smooth()) node.v = state.v(node.i, node.j);
    near &= (grid.from_centre(node.i, node.j) + node.u - node.home).norm() < slack;
  }
  return near;
}

void ContactForces::renew(const Lattice& lattice, const State& state) {
  cells_.clear();
  pairs_.clear();
  for (int node = 0; node < static_cast<int>(open_.size()); ++node) {
    OpenNode& own = open_[static_cast<std::size_t>(node)];
    own.home = lattice.grid.from_centre(own.i, own.j) + state.u(own.i, own.j);
    find_pairs(node, lattice, state.bonds);
  }
  faces_.find_near(open_, slack);
}

// Returns whether something touches, or did in the last step.
bool ContactForces::update(const Surroundings& around, State& state) {
  const Lattice& lattice = around.lattice;
  const bool touched = !forces_.empty();
  if (!move_nodes(lattice.grid, state)) renew(lattice, state);
  OrderFreeSum energy;
  for (const Pair& pair : pairs_) energy.add({push(pair), 0.0});
  const double stored = faces_.push(open_, around.heat, roughness_.friction);
  state.contact_lost += stored_before_ ? *stored_before_ - stored : 0.0;
  stored_before_.reset();
  energy_ = energy.value().x() + stored;
  collect(lattice);
  return touched || !forces_.empty();
}

double ContactForces::heat_work(const std::vector<double>& before,
                                const std::vector<double>& after) const {
  return faces_.energy(open_, after) - faces_.energy(open_, before);
}

double ContactForces::push(const Pair& pair) {
  OpenNode& p = open_[static_cast<std::size_t>(pair.one)];
  OpenNode& q = open_[static_cast<std::size_t>(pair.other)];
  const Vec2 apart = Vec2(q.i - p.i, q.j - p.j) + (q.u - p.u);
  const double r = apart.norm();
  if (!(r < pair.distance && r > 0.0)) return 0.0;
  const double overlap = pair.distance - r;
  const Vec2 force = (pair.strength * overlap / r) * apart;
  q.force.add(force);
  p.force.subtract(force);
  if (!roughness_.is_smooth()) resist(p, q, force);
  return 0.5 * pair.strength * overlap * overlap;
}

// `force` is that on the other one.
void ContactForces::resist(OpenNode& one, OpenNode& other, const Vec2& force) const {
  const double hold = hold_of_pair * std::min(one.inertia, other.inertia);
  const Vec2 loss = loss_of(roughness_, force, other.v - one.v, hold);
  other.loss.add(loss);
  one.loss.subtract(loss);
}

void ContactForces::collect(const Lattice& lattice) {
  forces_.clear();
  drag_.clear();
  for (const OpenNode& node : open_) {
    if (node.force.is_zero() && node.loss.is_zero()) continue;
    const double unit = unit_ / node.inertia;
    const Vec2 loss = node.loss.value();
    forces_.push_back({node.i, node.j, (node.force.value() + loss) * unit, node.inertia});
    if (!loss.isZero(0.0)) drag_.push_back({node.i, node.j, loss * unit, node.inertia});
  }
  const auto index = [&](const LoadedNode& load) { return lattice.grid.index(load.i, load.j); };
  std::ranges::sort(forces_, {}, index);
  std::ranges::sort(drag_, {}, index);
}

}  // namespace hackle
