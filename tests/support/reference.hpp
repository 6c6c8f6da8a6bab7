// SPDX-License-Identifier: MIT
// The rules of the engine written down a second time, as plainly as possible: bonds are pairs of
// nodes in a list, and a stretch is a difference of lengths, in extended precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "solver/simulation.hpp"

namespace hackle::test {

class Reference {
 public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 2, 1>;

  // Starts from the state of `simulation`, in its lattice units. The history at the start of a run
  // is the stretch of its bonds; a later state starts without history.
  explicit Reference(const Simulation& simulation)
      : step_(simulation.state().step),
        nx_(simulation.lattice().grid.nx),
        late_(simulation.numerics().breaking == Breaking::next_step) {
    const Lattice& lattice = simulation.lattice();
    const Grid& grid = lattice.grid;
    const Real dt = simulation.dt(), dx = grid.dx;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        u_.push_back(simulation.state().u(i, j).cast<Real>());
        v_.push_back(simulation.state().v(i, j).cast<Real>());
        add_node(simulation, i, j);
        add_bonds(simulation, dx * dt * dt, i, j);
      }
    for (const Node& node : nodes_) s0_.push_back(node.s00);
    take_heat(simulation);
    loads_.assign(u_.size(), Vector(0, 0));
    for (const LoadedNode& load : simulation.actions().forces)
      loads_[grid.index(load.i, load.j)] = load.acceleration.cast<Real>() * dt * dt / dx;
    if (simulation.state().is_start()) note_history();
  }

  // Takes the thermal strain of the next step from `simulation`.
  void take_heat(const Simulation& simulation) {
    for (std::size_t node = 0; node < simulation.thermal_strain().size(); ++node)
      nodes_[node].heat = simulation.thermal_strain()[node];
  }

  // Makes a leapfrog step.
  void step() {
    const std::vector<Vector> a = accelerations();
    for (std::size_t node = 0; node < u_.size(); ++node) {
      v_[node] += (step_ == 0 ? Real(0.5) : Real(1)) * a[node];
      u_[node] += v_[node];
    }
    ++step_;
  }

  // Breaks overstretched bonds, and stores the smallest stretch of every node for the next step.
  std::vector<Vector> accelerations() {
    std::vector<Vector> a(u_.size(), Vector(0, 0));
    for (Bond& bond : bonds_) {
      if (!bond.holds) continue;
      const Vector now = deformed(bond);
      const Node &one = nodes_[bond.from], &other = nodes_[bond.to];
      const Real s = stretch(bond);
      bond.holds = bond.safe || s <= std::min(s0_[bond.from], s0_[bond.to]);
      if (!bond.holds && !late_) continue;
      const Real length = bond.xi.norm();
      const Vector force = (one.c + other.c) / 2 * bond.unit * s / ((1 + s) * length) * now;
      a[bond.from] += force;
      a[bond.to] -= force;
    }
    note_history();
    for (std::size_t node = 0; node < a.size(); ++node)
      a[node] = a[node] / nodes_[node].rho + loads_[node];
    return a;
  }

  const Vector& u(int i, int j) const { return u_[index(i, j)]; }
  // Counts bonds that are intact in one of the two and not in the other.
  int differing_bonds(const Simulation& simulation) const {
    return static_cast<int>(std::ranges::count_if(bonds_, [&](const Bond& bond) {
      return bond.holds != simulation.state().bonds.holds(bond.place, bond.bit);
    }));
  }

 private:
  struct Node {
    Real c, rho, s00, alpha;
    Real heat = 0;  // thermal strain
  };
  struct Bond {
    std::size_t from = 0, to = 0;  // nodes
    Vector xi{0, 0};
    Real unit = 0;  // per unit of micromodulus
    bool safe = false;
    bool holds = true;
    std::ptrdiff_t place = 0;  // in the engine's bond bits
    int bit = 0;
  };

  Vector deformed(const Bond& bond) const { return bond.xi + u_[bond.to] - u_[bond.from]; }

  Real stretch(const Bond& bond) const {
    const Real ratio = deformed(bond).norm() / bond.xi.norm();
    return std::sqrt(ratio * ratio - nodes_[bond.from].heat - nodes_[bond.to].heat) - 1;
  }

  // Moves the threshold of each node by the smallest stretch of its intact bonds.
  void note_history() {
    constexpr Real none = std::numeric_limits<Real>::max();
    std::vector<Real> min(u_.size(), none);
    for (const Bond& bond : bonds_) {
      if (!bond.holds) continue;
      for (const std::size_t node : {bond.from, bond.to})
        min[node] = std::min(min[node], stretch(bond));
    }
    for (std::size_t node = 0; node < s0_.size(); ++node) {
      const Node& own = nodes_[node];
      s0_[node] = own.s00 - (min[node] == none ? Real(0) : own.alpha * min[node]);
    }
  }

  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * nx_ + i); }

  void add_node(const Simulation& simulation, int i, int j) {
    const Lattice& lattice = simulation.lattice();
    const std::size_t node = lattice.grid.index(i, j);
    const bool nothing = !lattice.material.empty() && lattice.material[node] == Lattice::void_node;
    const MaterialOnLattice& own =
        lattice.materials[lattice.material.empty() || nothing ? 0 : lattice.material[node]];
    const Real strength = lattice.strength.empty() ? Real(1) : Real(lattice.strength[node]);
    const Real stiffness = lattice.surface.empty() ? Real(1) : Real(lattice.surface[node]);
    nodes_.push_back({stiffness * own.calibration.c, own.material.rho,
                      strength * own.calibration.s0, own.material.alpha});
  }

  void add_bonds(const Simulation& simulation, Real unit, int i, int j) {
    const Lattice& lattice = simulation.lattice();
    const std::ptrdiff_t place = lattice.grid.layout().at(i, j);
    lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
      if (!lattice.grid.contains(i + a, j + b)) return;
      const bool safe = !lattice.unbreakable.empty() && lattice.unbreakable.holds(place, bit);
      bonds_.push_back({index(i, j), index(i + a, j + b), xi.cast<Real>(), unit * weight, safe,
                        simulation.state().bonds.holds(place, bit), place, bit});
    });
  }

  std::int64_t step_;
  int nx_;
  bool late_;  // an overstretched bond pulls once more
  std::vector<Node> nodes_;
  std::vector<Bond> bonds_;
  std::vector<Vector> u_, v_, loads_;
  std::vector<Real> s0_;
};

}  // namespace hackle::test
