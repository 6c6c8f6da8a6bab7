// SPDX-License-Identifier: MIT
#include "solver/statics/rigid_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "solver/terms/cell_overlap.hpp"

namespace hackle {
namespace {

// dx, between a body and a cell that it will hold; and that touches it already, to rounding.
constexpr double nearly = 1.0, touching = 1e-9;
// Along a body a cell slides. The tangent has this share of the stiffness there, or a plate that
// only bodies hold could shift without resistance; no force follows from it.
constexpr double sliding = 1e-3;

Vec2 product(const Stiffness& k, const Vec2& p) {
  return {k.xx * p.x() + k.xy * p.y(), k.xy * p.x() + k.yy * p.y()};
}

Stiffness along_and_across(double along, const Vec2& n) {
  const double across = sliding * along, more = along - across;
  return {across + more * n.x() * n.x(), more * n.x() * n.y(), across + more * n.y() * n.y()};
}

// How the springs of a body that a force leads resist it along the force, and how stiffly.
struct Resistance {
  double force = 0.0, stiffness = 0.0;
};

Resistance resistance_of(const std::vector<RigidContacts::Spring>& springs, const Vec2& along) {
  Resistance sum;
  for (const RigidContacts::Spring& spring : springs) {
    sum.force += spring.push.dot(along);
    sum.stiffness += along.dot(product(spring.stiffness, along));
  }
  return sum;
}

}  // namespace

RigidContacts::RigidContacts(const Lattice& lattice, const State& state, RestingBodies bodies,
                             std::string who)
    : lattice_(&lattice),
      state_(&state),
      bodies_(std::move(bodies.list)),
      strength_(bodies.strength),
      who_(std::move(who)) {
}

template <class Visit>
void RigidContacts::visit_overlaps(const RestingBody& body, const NodeVectors& u, double more,
                                   const Visit& visit) const {
  const Grid& grid = lattice_->grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (lattice_->is_void(i, j)) continue;
      const auto at = static_cast<std::size_t>(state_->layout.at(i, j));
      const Vec2 node = grid.from_centre(i, j) + state_->origin + Vec2(u.x[at], u.y[at]);
      const Vec2 overlap = body.body.overlap(node, body.centre, more);
      if (!overlap.isZero(0.0)) visit(i, j, overlap);
    }
}

// The spring resists along the overlap only: what a disc turns the push by is of the order of the
// overlap over its radius. A cell at a distance of less than `more` has a spring without a push:
// what just touches holds the plate before it bears anything.
std::vector<RigidContacts::Spring> RigidContacts::springs_of(std::size_t k, const NodeVectors& u,
                                                             double more) const {
  std::vector<Spring> found;
  visit_overlaps(bodies_[k], u, more, [&](int i, int j, const Vec2& overlap) {
    const double stiff = strength_ * lattice_->micromodulus_at(i, j) / lattice_->calibration.c;
    const double size = overlap.norm();
    const Vec2 n = overlap / size;
    found.push_back(
        {i, j, k, stiff * std::max(size - more, 0.0) * n, along_and_across(stiff, n), n});
  });
  return found;
}

void RigidContacts::add_springs(const std::vector<Spring>& more) {
  springs_.insert(springs_.end(), more.begin(), more.end());
}

void RigidContacts::find(const NodeVectors& u) {
  springs_.clear();
  for (std::size_t k = 0; k < bodies_.size(); ++k)
    add_springs(bodies_[k].body.is_pressed() ? borne(k, u) : springs_of(k, u, touching));
}

void RigidContacts::find_placed(const NodeVectors& u) {
  springs_.clear();
  for (std::size_t k = 0; k < bodies_.size(); ++k) add_springs(springs_of(k, u, touching));
}

// Newton's method on a force that grows with the way, steeper and steeper for a box; where nothing
// is touched the body goes on by half a spacing.
std::vector<RigidContacts::Spring> RigidContacts::borne(std::size_t k, const NodeVectors& u) {
  constexpr int max_steps = 200;
  constexpr double enough = 1e-12;
  RestingBody& body = bodies_[k];
  const Vec2 along = body.body.along();
  const double force = std::max(body.force, 0.0);  // what is drawn back touches nothing
  const double farthest = 2.0 * (lattice_->grid.nx + lattice_->grid.ny);
  for (int step = 0; step < max_steps && (body.centre - body.body.start).norm() < farthest;
       ++step) {
    std::vector<Spring> springs = springs_of(k, u, touching);
    const auto [resists, stiffness] = resistance_of(springs, along);
    const double left = force - resists;
    if (std::abs(left) <= enough * force) return springs;
    const double way = stiffness > 0.0 ? left / stiffness : std::copysign(0.5, left);
    if (std::abs(way) <= 1e-14 * farthest) return springs;
    body.centre += std::clamp(way, -0.5, 0.5) * along;
  }
  throw Error(ErrorKind::refused,
              fmt::format("{}: nothing bears the force that leads a {}", who_, body.body.who),
              "lead it against the plate, and hold the plate on its other side");
}

std::vector<RigidContacts::Spring> RigidContacts::holds(const NodeVectors& u) const {
  RigidContacts near = *this;
  near.springs_.clear();
  for (std::size_t k = 0; k < bodies_.size(); ++k)
    if (!bodies_[k].body.is_pressed()) near.add_springs(springs_of(k, u, nearly));
  return near.springs_;
}

double RigidContacts::rounding() const {
  constexpr double of_places = 8.0 * std::numeric_limits<double>::epsilon();
  return of_places * 2.0 * strength_ *
         (lattice_ == nullptr ? 0 : lattice_->grid.nx + lattice_->grid.ny);
}

void RigidContacts::add_pushes(NodeVectors& force) const {
  for (const Spring& spring : springs_) {
    const auto at = static_cast<std::size_t>(state_->layout.at(spring.i, spring.j));
    force.x[at] += spring.push.x();
    force.y[at] += spring.push.y();
  }
}

void RigidContacts::add_change(const NodeVectors& p, NodeVectors& result) const {
  for (auto first = springs_.begin(); first != springs_.end();) {
    const std::size_t k = first->body;
    const auto last =
        std::find_if(first, springs_.end(), [k](const Spring& spring) { return spring.body != k; });
    const auto motion = [&](const Spring& spring) {
      const auto at = static_cast<std::size_t>(state_->layout.at(spring.i, spring.j));
      return Vec2(p.x[at], p.y[at]);
    };
    Vec2 follows(0, 0);
    if (bodies_[k].body.is_pressed()) {
      const Vec2 along = bodies_[k].body.along();
      double pulled = 0.0, stiffness = 0.0;
      for (auto spring = first; spring != last; ++spring) {
        const Vec2 stiff = product(spring->stiffness, along);
        pulled += stiff.dot(motion(*spring));
        stiffness += stiff.dot(along);
      }
      if (stiffness > 0.0) follows = pulled / stiffness * along;
    }
    for (; first != last; ++first) {
      const auto at = static_cast<std::size_t>(state_->layout.at(first->i, first->j));
      const Vec2 change = product(first->stiffness, motion(*first) - follows);
      result.x[at] -= change.x();
      result.y[at] -= change.y();
    }
  }
}

}  // namespace hackle
