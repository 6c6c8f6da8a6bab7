// SPDX-License-Identifier: MIT
// Stiffness damping, Rayleigh's beta: an intact bond pulls as if it were stretched by beta times
// the rate of its stretch more, along itself. Linear and angular momentum are kept to rounding, and
// rigid motion, however fast, makes no force: with h the relative displacement of the ends of a
// bond xi and w its change in the last step, the measure e of src/solver/README.md 2.1 has changed
// by 2 w.(xi + h - w/2)/L^2, which is exact (src/solver/README.md 7.7).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lattice/carve.hpp"
#include "solver/node_vectors.hpp"
#include "solver/terms/makers.hpp"

namespace hackle {
namespace {

// One image of an offset: bonds of a row to the nodes at a distance.
struct Offset {
  int a = 0;
  int b = 0;
  Vec2 xi{0, 0};
  double per_length2 = 0.0;
  double strength = 0.0;  // of the plate's own material
  int bit = 0;            // in the bits of the node that keeps the bond, Family
  bool is_kept = true;    // by the node itself, not by the other end
};

// All images of an offset: two, or four. Those of a node are added as (0 + 1) + (2 + 3), across and
// along: sums that mirrors only commute.
using Group = std::vector<Offset>;

Offset opposite(const Offset& offset) {
  return {-offset.a, -offset.b, -offset.xi, offset.per_length2, offset.strength, offset.bit, false};
}

Offset kept(const Images& images, int sign, double strength) {
  const Vec2& xi = images.xi;
  return {sign * images.a,
          images.b,
          {sign * xi.x(), xi.y()},
          1.0 / xi.squaredNorm(),
          strength * images.weight / xi.norm(),
          images.first_bit + (sign < 0 ? 1 : 0)};
}

Group group_of(const Images& images, double strength) {
  const Offset one = kept(images, 1, strength);
  if (!images.is_quad()) return {one, opposite(one)};
  const Offset mirrored = kept(images, -1, strength);
  return {one, mirrored, opposite(mirrored), opposite(one)};
}

// A vector per node of a row.
struct RowOfVectors {
  explicit RowOfVectors(int nx) : x(static_cast<std::size_t>(nx)), y(x) {}
  std::vector<double> x, y;
};

template <class Real>
class Sweep {
 public:
  // `half` is half the micromodulus of every place, relative to that of the plate's own material;
  // empty where all are alike.
  Sweep(const Grid& grid, const BondBits& bonds, const Motion<Real>& motion,
        const std::vector<double>& half)
      : layout_(grid.layout()), bonds_(bonds), motion_(motion), half_(half) {}

  bool moves(int j) const {
    const auto first = layout_.at(0, j), end = layout_.at(layout_.nx, j);
    const auto some = [&](const Values<Real>& v) {
      return std::any_of(v.begin() + first, v.begin() + end, [](Real x) { return x != Real{0}; });
    };
    return some(motion_.vx) || some(motion_.vy);
  }

  // Computes the forces of one offset on row j. Ghosts have no bonds; what stands there is not
  // used.
  void pull(const Offset& offset, int j, RowOfVectors& force) const {
    if (j + offset.b < 0 || j + offset.b >= layout_.ny) {
      std::ranges::fill(force.x, 0.0);
      std::ranges::fill(force.y, 0.0);
    } else if (half_.empty()) {
      pull_row(offset, j, force, [](std::ptrdiff_t, std::ptrdiff_t) { return 1.0; });
    } else {
      pull_row(offset, j, force, [half = half_.data()](std::ptrdiff_t at, std::ptrdiff_t other) {
        return half[at] + half[other];
      });
    }
  }

 private:
  template <class Stiffness>
  void pull_row(const Offset& offset, int j, RowOfVectors& force,
                const Stiffness& stiffness) const {
    const std::ptrdiff_t first = layout_.at(0, j), way = offset.b * layout_.stride() + offset.a;
    const std::uint32_t mask = std::uint32_t{1} << (offset.bit & 31);
    const std::uint32_t* words = bonds_.words().data() +
                                 static_cast<std::size_t>(offset.bit / 32) * bonds_.plane() +
                                 (offset.is_kept ? 0 : way);
    const Real *ux = motion_.ux.data(), *uy = motion_.uy.data(), *vx = motion_.vx.data(),
               *vy = motion_.vy.data();
    const double xi_x = offset.xi.x(), xi_y = offset.xi.y();
    const double per_length2 = offset.per_length2, strength = offset.strength;
    double *force_x = force.x.data(), *force_y = force.y.data();
    const auto difference = [](const Real* u, std::ptrdiff_t at, std::ptrdiff_t other) {
      return static_cast<double>(u[other]) - static_cast<double>(u[at]);
    };
    for (std::ptrdiff_t i = 0; i < layout_.nx; ++i) {
      const std::ptrdiff_t at = first + i, other = at + way;
      const double wx = difference(vx, at, other), wy = difference(vy, at, other);
      const double yx = xi_x + difference(ux, at, other), yy = xi_y + difference(uy, at, other);
      const double rate = per_length2 * (wx * (yx - 0.5 * wx) + wy * (yy - 0.5 * wy));
      const double pull = rate * strength * stiffness(at, other);
      const bool holds = (words[at] & mask) != 0;
      force_x[i] = holds ? pull * yx : 0.0;
      force_y[i] = holds ? pull * yy : 0.0;
    }
  }

  NodeLayout layout_;
  const BondBits& bonds_;
  const Motion<Real>& motion_;
  const std::vector<double>& half_;
};

std::vector<double> half_micromoduli(const Lattice& lattice) {
  if (lattice.material.empty() && lattice.surface.empty()) return {};
  const NodeLayout layout = lattice.grid.layout();
  std::vector<double> half(layout.size());
  for_nodes(lattice.grid, [&](int i, int j) {
    half[static_cast<std::size_t>(layout.at(i, j))] =
        0.5 * lattice.micromodulus_at(i, j) / lattice.calibration.c;
  });
  return half;
}

class StiffnessDamping final : public Term {
 public:
  StiffnessDamping(double beta, const Lattice& lattice, double dt)
      : half_(half_micromoduli(lattice)) {
    const double strength =
        beta / dt * lattice.calibration.c * lattice.grid.dx * dt * dt / lattice.rho;
    for (const Images& images : lattice.family.images())
      groups_.push_back(group_of(images, strength));
  }

  std::unique_ptr<Term> clone() const override { return std::make_unique<StiffnessDamping>(*this); }
  std::string_view name() const override { return "damping"; }
  std::span<const LoadedNode> forces() const override { return forces_; }
  std::span<const LoadedNode> drag() const override { return forces_; }
  bool varies() const override { return true; }
  bool update(const Surroundings& around, State& state) override {
    const bool acted = !forces_.empty();
    std::visit(
        [&]<class Real>(const Motion<Real>& motion) {
          sweep(around, Sweep<Real>(around.lattice.grid, state.bonds, motion, half_));
        },
        state.motion);
    return acted || !forces_.empty();
  }

 private:
  template <class Real>
  void sweep(const Surroundings& around, const Sweep<Real>& bonds) {
    const Lattice& lattice = around.lattice;
    const int rows = lattice.grid.ny, reach = lattice.family.reach();
    std::vector<char> moves(static_cast<std::size_t>(rows));
    for_rows(around.threads, rows,
             [&](int j) { moves[static_cast<std::size_t>(j)] = bonds.moves(j) ? 1 : 0; });
    of_row_.resize(static_cast<std::size_t>(rows));
    for_rows(around.threads, rows, [&](int j) {
      std::vector<LoadedNode>& row = of_row_[static_cast<std::size_t>(j)];
      row.clear();
      const auto first = moves.begin() + std::max(j - reach, 0),
                 end = moves.begin() + std::min(j + reach + 1, rows);
      if (std::find(first, end, 1) != end) add_row(lattice, bonds, around.dt, j, row);
    });
    forces_.clear();
    for (const std::vector<LoadedNode>& row : of_row_)
      forces_.insert(forces_.end(), row.begin(), row.end());
  }

  template <class Real>
  RowOfVectors sum_of_row(const Sweep<Real>& bonds, int nx, int j) const {
    RowOfVectors sum(nx), one(nx), two(nx), three(nx), four(nx);
    const auto add = [&](std::vector<double> RowOfVectors::*axis, bool quad) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(nx); ++i)
        (sum.*axis)[i] +=
            quad ? ((one.*axis)[i] + (two.*axis)[i]) + ((three.*axis)[i] + (four.*axis)[i])
                 : (one.*axis)[i] + (two.*axis)[i];
    };
    for (const Group& group : groups_) {
      const bool quad = group.size() == 4;
      bonds.pull(group[0], j, one);
      bonds.pull(group[1], j, two);
      if (quad) bonds.pull(group[2], j, three);
      if (quad) bonds.pull(group[3], j, four);
      add(&RowOfVectors::x, quad);
      add(&RowOfVectors::y, quad);
    }
    return sum;
  }

  template <class Real>
  void add_row(const Lattice& lattice, const Sweep<Real>& bonds, double dt, int j,
               std::vector<LoadedNode>& row) const {
    const double unit = lattice.grid.dx / (dt * dt);
    const RowOfVectors sum = sum_of_row(bonds, lattice.grid.nx, j);
    for (int i = 0; i < lattice.grid.nx; ++i) {
      const Vec2 force(sum.x[static_cast<std::size_t>(i)], sum.y[static_cast<std::size_t>(i)]);
      if (force.isZero(0.0)) continue;
      const double inertia = lattice.material_at(i, j).material.rho / lattice.rho;
      row.push_back({i, j, (unit / inertia) * force, inertia});
    }
  }

  std::vector<double> half_;
  std::vector<Group> groups_;
  std::vector<std::vector<LoadedNode>> of_row_;
  std::vector<LoadedNode> forces_;
};

}  // namespace

std::unique_ptr<Term> make_stiffness_damping(const Plate& plate, const Lattice& lattice,
                                             double dt) {
  const double beta = plate.loads.stiffness_damping;
  return beta > 0.0 ? std::make_unique<StiffnessDamping>(beta, lattice, dt) : nullptr;
}

}  // namespace hackle
