// SPDX-License-Identifier: MIT
#include "solver/statics/fragments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "base/union_find.hpp"

namespace hackle {
namespace {

void widen(Fragment& fragment, int i, int j) {
  if (fragment.nodes++ == 0)
    fragment.first_i = fragment.last_i = i, fragment.first_j = fragment.last_j = j;
  fragment.first_i = std::min(fragment.first_i, i);
  fragment.last_i = std::max(fragment.last_i, i);
  fragment.first_j = std::min(fragment.first_j, j);
  fragment.last_j = std::max(fragment.last_j, j);
}

}  // namespace

Fragments::Fragments(const Lattice& lattice, const State& state, const NodeVectors& mobile,
                     Threads threads, const std::vector<Hold>& holds)
    : grid_(lattice.grid), layout_(state.layout), threads_(std::move(threads)) {
  list_fragments(roots(lattice, state), mobile);
  for (const Hold& hold : holds)
    if (const int fragment = of_node_[grid_.index(hold.i, hold.j)]; fragment != none)
      list_[static_cast<std::size_t>(fragment)].is_held = true;
  for (std::size_t fragment = 0; fragment < list_.size(); ++fragment) {
    measure(fragment);
    find_motions(fragment, mobile, holds);
  }
}

// Returns the smallest node of the fragment of each node; the node itself if it has no bonds.
std::vector<std::size_t> Fragments::roots(const Lattice& lattice, const State& state) const {
  UnionFind fragments(grid_.nodes());
  for (int j = 0; j < grid_.ny; ++j)
    for (int i = 0; i < grid_.nx; ++i)
      lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
        if (state.bonds.holds(layout_.at(i, j), bit))
          fragments.unite(grid_.index(i, j), grid_.index(i + a, j + b));
      });
  return fragments.firsts();
}

void Fragments::list_fragments(const std::vector<std::size_t>& root, const NodeVectors& mobile) {
  std::vector<int> size(root.size());
  for (const std::size_t node : root) ++size[node];
  of_node_.assign(root.size(), none);
  std::vector<int> place(root.size(), none);
  for (int j = 0; j < grid_.ny; ++j)
    for (int i = 0; i < grid_.nx; ++i) {
      const std::size_t node = grid_.index(i, j);
      const std::size_t min = root[node];
      if (size[min] == 1) continue;
      if (place[min] == none) {
        place[min] = static_cast<int>(list_.size());
        list_.emplace_back();
      }
      of_node_[node] = place[min];
      Fragment& fragment = list_[static_cast<std::size_t>(place[min])];
      widen(fragment, i, j);
      const auto at = static_cast<std::size_t>(layout_.at(i, j));
      if (mobile.x[at] == 0.0 || mobile.y[at] == 0.0) fragment.is_held = true;
    }
}

template <class Work>
void Fragments::for_row(std::size_t fragment, int j, const Work& work) const {
  const Fragment& box = list_[fragment];
  for (int i = box.first_i; i <= box.last_i; ++i)
    if (of_node_[grid_.index(i, j)] == static_cast<int>(fragment))
      work(Vec2(grid_.from_centre(i, j) - box.centre), static_cast<std::size_t>(layout_.at(i, j)));
}

template <class Term>
double Fragments::sum(std::size_t fragment, const Term& term) const {
  const Fragment& box = list_[fragment];
  std::vector<double> of_row(static_cast<std::size_t>(box.last_j - box.first_j + 1));
  for_rows(threads_, static_cast<int>(of_row.size()), [&](int k) {
    const int j = box.first_j + k;
    of_row[static_cast<std::size_t>(k)] = paired_sum(box.last_i - box.first_i + 1, [&](int q) {
      const int i = box.first_i + q;
      if (of_node_[grid_.index(i, j)] != static_cast<int>(fragment)) return 0.0;
      return term(Vec2(grid_.from_centre(i, j) - box.centre),
                  static_cast<std::size_t>(layout_.at(i, j)));
    });
  });
  return sum_of_rows(of_row);
}

void Fragments::measure(std::size_t fragment) {
  Fragment& box = list_[fragment];
  const double x = sum(fragment, [](const Vec2& p, std::size_t) { return p.x(); });
  const double y = sum(fragment, [](const Vec2& p, std::size_t) { return p.y(); });
  box.centre = Vec2(x, y) / box.nodes;
  box.inertia = sum(fragment, [](const Vec2& p, std::size_t) { return p.squaredNorm(); });
}

// Finds the motions that leave every held component at rest: the null space of the sum of their
// squares. Rotation is measured at the radius of gyration, so that all three have equal weight.
void Fragments::find_motions(std::size_t fragment, const NodeVectors& mobile,
                             const std::vector<Hold>& holds) {
  Fragment& box = list_[fragment];
  const double radius = std::sqrt(box.inertia / box.nodes);
  const std::array<RigidMotion, 3> all{{{{1, 0}, 0}, {{0, 1}, 0}, {{0, 0}, 1.0 / radius}}};
  if (!box.is_held) {
    box.motions.assign(all.begin(), all.end());
    return;
  }
  Eigen::Matrix3d hindrance = Eigen::Matrix3d::Zero();
  for (int j = box.first_j; j <= box.last_j; ++j)
    for_row(fragment, j, [&](const Vec2& x, std::size_t at) {
      const Eigen::Vector3d along_x(1, 0, -x.y() / radius), along_y(0, 1, x.x() / radius);
      if (mobile.x[at] == 0.0) hindrance += along_x * along_x.transpose();
      if (mobile.y[at] == 0.0) hindrance += along_y * along_y.transpose();
    });
  for (const Hold& hold : holds) {
    if (of_node_[grid_.index(hold.i, hold.j)] != static_cast<int>(fragment)) continue;
    const Vec2 x = grid_.from_centre(hold.i, hold.j) - box.centre, &n = hold.along;
    const Eigen::Vector3d along(n.x(), n.y(), (x.x() * n.y() - x.y() * n.x()) / radius);
    hindrance += along * along.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(hindrance);
  for (int k = 0; k < 3; ++k) {
    if (modes.eigenvalues()[k] > 1e-9) continue;
    const Eigen::Vector3d mode = modes.eigenvectors().col(k);
    box.motions.push_back({{mode[0], mode[1]}, mode[2] / radius});
  }
}

Resultant Fragments::resultant(std::size_t fragment, const NodeVectors& force,
                               const NodeVectors& u) const {
  const Values<double>&fx = force.x, &fy = force.y;
  const auto moved = [&](const Vec2& x, std::size_t at) {
    return Vec2(x + Vec2(u.x[at], u.y[at]));
  };
  Resultant result;
  result.force.x() = sum(fragment, [&](const Vec2&, std::size_t at) { return fx[at]; });
  result.force.y() = sum(fragment, [&](const Vec2&, std::size_t at) { return fy[at]; });
  result.moment = sum(fragment, [&](const Vec2& x, std::size_t at) {
    const Vec2 y = moved(x, at);
    return y.x() * fy[at] - y.y() * fx[at];
  });
  result.virial = sum(fragment, [&](const Vec2& x, std::size_t at) {
    const Vec2 y = moved(x, at);
    return y.x() * fx[at] + y.y() * fy[at];
  });
  return result;
}

void Fragments::take_out_rigid(NodeVectors& vector) const {
  Values<double>&vx = vector.x, &vy = vector.y;
  for (std::size_t fragment = 0; fragment < list_.size(); ++fragment) {
    const Fragment& box = list_[fragment];
    if (box.is_held) continue;
    const double x = sum(fragment, [&](const Vec2&, std::size_t at) { return vx[at]; }) / box.nodes;
    const double y = sum(fragment, [&](const Vec2&, std::size_t at) { return vy[at]; }) / box.nodes;
    const double spin =
        sum(fragment,
            [&](const Vec2& p, std::size_t at) { return p.x() * vy[at] - p.y() * vx[at]; }) /
        box.inertia;
    for_rows(threads_, box.last_j - box.first_j + 1, [&](int k) {
      for_row(fragment, box.first_j + k, [&](const Vec2& p, std::size_t at) {
        vx[at] -= x - spin * p.y();
        vy[at] -= y + spin * p.x();
      });
    });
  }
}

void Fragments::turn(std::size_t fragment, double angle, NodeVectors& u) const {
  const Fragment& box = list_[fragment];
  const double x = sum(fragment, [&](const Vec2&, std::size_t at) { return u.x[at]; }) / box.nodes;
  const double y = sum(fragment, [&](const Vec2&, std::size_t at) { return u.y[at]; }) / box.nodes;
  const double s = std::sin(angle), half = std::sin(0.5 * angle);
  const double c = -2.0 * half * half;  // cos - 1 without cancellation
  for_rows(threads_, box.last_j - box.first_j + 1, [&](int k) {
    for_row(fragment, box.first_j + k, [&](const Vec2& p, std::size_t at) {
      const double px = p.x() + (u.x[at] - x), py = p.y() + (u.y[at] - y);
      u.x[at] += c * px - s * py;
      u.y[at] += s * px + c * py;
    });
  });
}

}  // namespace hackle
