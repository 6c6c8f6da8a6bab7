// SPDX-License-Identifier: MIT
#include "solver/statics/conjugate_gradient.hpp"

#include <algorithm>

#include "solver/statics/rigid_contacts.hpp"

namespace hackle {
namespace {

// The inverse of a node's own stiffness, restricted to its mobile components. A node that bonds
// hold in one direction only counts as equally stiff in the other.
Stiffness inverse_of(const Stiffness& own, double mobile_x, double mobile_y) {
  constexpr double singular = 1e-9;
  const double trace = own.xx + own.yy;
  const double determinant = own.xx * own.yy - own.xy * own.xy;
  if (mobile_x != 0.0 && mobile_y != 0.0 && determinant > singular * (trace * trace))
    return {own.yy / determinant, -own.xy / determinant, own.xx / determinant};
  const auto reciprocal = [&](double mobile, double value) {
    return mobile != 0.0 && trace > 0.0 ? 1.0 / std::max(value, singular * trace) : 0.0;
  };
  if (mobile_x != 0.0 && mobile_y != 0.0) return {reciprocal(1, trace), 0, reciprocal(1, trace)};
  return {reciprocal(mobile_x, own.xx), 0.0, reciprocal(mobile_y, own.yy)};
}

void add(const Stiffness& more, Stiffness& sum) {
  sum = {sum.xx + more.xx, sum.xy + more.xy, sum.yy + more.yy};
}

}  // namespace

ConjugateGradient::ConjugateGradient(const LinearisedBonds& net, const Fragments& fragments,
                                     const NodeVectors& mobile, CoarseSpace* coarse,
                                     const RigidContacts* contacts)
    : net_(&net),
      fragments_(&fragments),
      mobile_(&mobile),
      coarse_(coarse),
      contacts_(contacts),
      layout_(net.layout()),
      has_free_fragments_(
          std::ranges::any_of(fragments.list(), [](const Fragment& p) { return !p.is_held; })),
      inverse_(static_cast<std::size_t>(layout_.nx) * static_cast<std::size_t>(layout_.ny)),
      p_(layout_),
      q_(layout_),
      r_(layout_),
      z_(layout_),
      of_row_(static_cast<std::size_t>(layout_.ny)),
      max_of_row_(of_row_.size()) {
  invert();
}

void ConjugateGradient::invert() {
  std::vector<Stiffness> springs(inverse_.size());
  if (contacts_ != nullptr)
    for (const RigidContacts::Spring& spring : contacts_->springs())
      add(spring.stiffness, springs[net_->lattice().grid.index(spring.i, spring.j)]);
  for_rows(net_->threads(), layout_.ny, [&](int j) {
    for (int i = 0; i < layout_.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout_.at(i, j));
      const std::size_t node = net_->lattice().grid.index(i, j);
      add(net_->own_stiffness(i, j), springs[node]);
      inverse_[node] = inverse_of(springs[node], mobile_->x[at], mobile_->y[at]);
    }
  });
}

void ConjugateGradient::apply(const NodeVectors& p, NodeVectors& change) {
  for_rows(net_->threads(), layout_.ny, [&](int j) { net_->apply_row(p, change, j); });
  if (contacts_ != nullptr) contacts_->add_change(p, change);
}

void ConjugateGradient::start(const NodeVectors& force, const NodeVectors& d) {
  apply(d, r_);
  for_rows(net_->threads(), layout_.ny, [&](int j) {
    for (int i = 0; i < layout_.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout_.at(i, j));
      r_.x[at] = mobile_->x[at] * (force.x[at] + r_.x[at]);
      r_.y[at] = mobile_->y[at] * (force.y[at] + r_.y[at]);
    }
  });
  if (has_free_fragments_) fragments_->take_out_rigid(r_);
}

double ConjugateGradient::curvature() {
  apply(p_, q_);
  for_rows(net_->threads(), layout_.ny, [&](int j) {
    for (int i = 0; i < layout_.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout_.at(i, j));
      q_.x[at] *= mobile_->x[at];
      q_.y[at] *= mobile_->y[at];
    }
    of_row_[static_cast<std::size_t>(j)] = -dot_of_row(layout_, p_, q_, j);
  });
  return sum_of_rows(of_row_);
}

void ConjugateGradient::go(double distance, NodeVectors& d) {
  for_rows(net_->threads(), layout_.ny, [&](int j) {
    for (int i = 0; i < layout_.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout_.at(i, j));
      d.x[at] += distance * p_.x[at];
      d.y[at] += distance * p_.y[at];
      r_.x[at] += distance * q_.x[at];
      r_.y[at] += distance * q_.y[at];
    }
  });
  if (has_free_fragments_) fragments_->take_out_rigid(r_);
}

ConjugateGradient::Sums ConjugateGradient::precondition() {
  for_rows(net_->threads(), layout_.ny, [&](int j) {
    const Stiffness* inverse =
        &inverse_[static_cast<std::size_t>(j) * static_cast<std::size_t>(layout_.nx)];
    for (int i = 0; i < layout_.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout_.at(i, j));
      z_.x[at] = inverse[i].xx * r_.x[at] + inverse[i].xy * r_.y[at];
      z_.y[at] = inverse[i].xy * r_.x[at] + inverse[i].yy * r_.y[at];
    }
    max_of_row_[static_cast<std::size_t>(j)] = largest_of_row(layout_, r_, j);
  });
  if (coarse_ != nullptr) coarse_->add_answer(r_, z_);
  if (has_free_fragments_) fragments_->take_out_rigid(z_);
  return {dot(r_, z_), max_of_rows(max_of_row_)};
}

double ConjugateGradient::dot(const NodeVectors& a, const NodeVectors& b) {
  for_rows(net_->threads(), layout_.ny,
           [&](int j) { of_row_[static_cast<std::size_t>(j)] = dot_of_row(layout_, a, b, j); });
  return sum_of_rows(of_row_);
}

void ConjugateGradient::turn_to(double share) {
  for_rows(net_->threads(), layout_.ny, [&](int j) {
    for (int i = 0; i < layout_.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout_.at(i, j));
      p_.x[at] = z_.x[at] + share * p_.x[at];
      p_.y[at] = z_.y[at] + share * p_.y[at];
    }
  });
}

ConjugateGradient::Outcome ConjugateGradient::solve(const NodeVectors& force, NodeVectors& d,
                                                    double share, double goal, int max,
                                                    const std::function<void(double left)>& look) {
  start(force, d);
  Sums sums = precondition();
  turn_to(0.0);
  const double enough = std::max(share * sums.largest, goal);
  Outcome outcome;
  while (outcome.iterations < max && sums.largest > enough) {
    const double bend = curvature();
    outcome.is_positive = bend > 0.0;
    if (!outcome.is_positive) break;
    const double distance = sums.product / bend, before = sums.product;
    go(distance, d);
    ++outcome.iterations;
    sums = precondition();
    // Polak and Ribiere: the coarse space is symmetrised in some iterations only, so it is not one
    // fixed preconditioner.
    turn_to(std::max(0.0, distance * dot(z_, q_) / before));
    look(sums.largest);
  }
  return outcome;
}

}  // namespace hackle
