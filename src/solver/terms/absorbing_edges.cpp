// SPDX-License-Identifier: MIT
// Absorbing edges: dashpots of the impedance of a plane wave, rho c per area, longitudinal across
// the edge and shear along it. A wave that arrives straight finds the force that the plate beyond
// would bear, and leaves (Lysmer and Kuhlemeyer 1969).
//
// The dashpot is spread over one horizon, in proportion to 1 - d/delta at depth d: bonds see no
// sharper edge. Concentrated on the outermost nodes it would be unstable at the usual step; over a
// wider layer it would send short waves back (src/solver/README.md 7.5).
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "solver/terms/makers.hpp"

namespace hackle {
namespace {

using Where = Absorber::Where;

// Returns the share of the dashpot in each row of nodes from the edge inwards; their sum is 1.
std::vector<double> shares_of_rows(double m) {
  std::vector<double> shares;
  double sum = 0.0;
  for (double depth = 0.5; depth < m; depth += 1.0) sum += shares.emplace_back(1.0 - depth / m);
  for (double& share : shares) share /= sum;
  return shares;
}

// What absorbs: the share in rows from each edge inwards, by the edge.
class Layers {
 public:
  Layers(const std::vector<Absorber>& absorbers, double m) : shares_(shares_of_rows(m)) {
    for (const Absorber& absorber : absorbers) {
      at_sides_[0] |= is_at(absorber, Where::left);
      at_sides_[1] |= is_at(absorber, Where::right);
      at_sides_[2] |= is_at(absorber, Where::bottom);
      at_sides_[3] |= is_at(absorber, Where::top);
    }
  }

  int depth() const { return static_cast<int>(shares_.size()); }
  // Returns the impedance at a node per mass and spacing, 1/m of wave speeds in m/s. Where layers
  // meet the stiffer one counts, in any order.
  Vec2 drag(const Grid& grid, int i, int j, double longitudinal, double shear) const {
    const double across_x = std::max(share(0, i), share(1, grid.nx - 1 - i));
    const double across_y = std::max(share(2, j), share(3, grid.ny - 1 - j));
    return {std::max(longitudinal * across_x, shear * across_y),
            std::max(shear * across_x, longitudinal * across_y)};
  }

 private:
  static bool is_at(const Absorber& absorber, Where side) {
    return absorber.edge == Where::all || absorber.edge == side;
  }
  double share(std::size_t side, int row) const {
    return at_sides_[side] && row < depth() ? shares_[static_cast<std::size_t>(row)] : 0.0;
  }

  std::vector<double> shares_;
  std::array<bool, 4> at_sides_{};
};

struct Dashpot {
  int i = 0;
  int j = 0;
  double inertia = 1.0;  // density over Lattice::rho
  Vec2 drag{0, 0};       // the share of the velocity that it takes in a step
};

std::vector<Dashpot> dashpots_of(const Plate& plate, const Lattice& lattice, double dt) {
  const Layers layers(plate.loads.absorbers, lattice.family.m());
  const Grid& grid = lattice.grid;
  std::vector<Dashpot> dashpots;
  for_nodes(grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    const MaterialOnLattice& own = lattice.material_at(i, j);
    const double rho = own.material.rho, unit = dt / grid.dx;
    const Moduli& moduli = own.calibration.moduli;
    const Vec2 drag =
        unit * layers.drag(grid, i, j, std::sqrt(moduli.C11 / rho), std::sqrt(moduli.C12 / rho));
    if (!drag.isZero()) dashpots.push_back({i, j, rho / lattice.rho, drag});
  });
  if (dashpots.empty())
    throw Error(ErrorKind::refused, "absorb: there is no node within a horizon of its edge",
                "name an edge of the rectangle that the plate reaches");
  return dashpots;
}

class AbsorbingEdges final : public Term {
 public:
  explicit AbsorbingEdges(std::vector<Dashpot> dashpots) : dashpots_(std::move(dashpots)) {}

  std::unique_ptr<Term> clone() const override { return std::make_unique<AbsorbingEdges>(*this); }
  std::string_view name() const override { return "absorbing edges"; }
  std::span<const LoadedNode> forces() const override { return forces_; }
  std::span<const LoadedNode> drag() const override { return forces_; }
  bool varies() const override { return true; }
  bool resists() const override { return true; }
  bool keeps_to_rows() const override { return true; }

  // Nodes at rest are left out: tiles that nothing has reached stay still.
  bool update(const Surroundings& around, State& state) override {
    const double unit = around.lattice.grid.dx / (around.dt * around.dt);
    const bool acted = !forces_.empty();
    forces_.clear();
    for (const Dashpot& dashpot : dashpots_) {
      if (!around.slab.owns(dashpot.j)) continue;
      const Vec2 v = state.v(dashpot.i, dashpot.j);
      if (!v.isZero(0.0))
        forces_.push_back(
            {dashpot.i, dashpot.j, -unit * dashpot.drag.cwiseProduct(v), dashpot.inertia});
    }
    return acted || !forces_.empty();
  }

 private:
  std::vector<Dashpot> dashpots_;
  std::vector<LoadedNode> forces_;
};

}  // namespace

std::unique_ptr<Term> make_absorbing_edges(const Plate& plate, const Lattice& lattice, double dt) {
  if (plate.loads.absorbers.empty()) return nullptr;
  return std::make_unique<AbsorbingEdges>(dashpots_of(plate, lattice, dt));
}

}  // namespace hackle
