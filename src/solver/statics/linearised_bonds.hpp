// SPDX-License-Identifier: MIT
// The bonds of a plate as springs in equilibrium: exact forces, stretches and tangent, in double
// precision, without breaking. In lattice units: lengths in dx, force densities in c dx^2 with the
// micromodulus c of the plate's own material.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lattice/lattice.hpp"
#include "solver/broken_bond.hpp"
#include "solver/node_vectors.hpp"
#include "solver/state.hpp"

namespace hackle {

// The derivative of the force of a bond with respect to the relative displacement of its ends.
struct Stiffness {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

// A bond above its critical stretch.
struct Overstretched {
  std::ptrdiff_t at = 0;  // place of the node that keeps it
  int bit = 0;
  double ratio = 0.0;   // of its stretch to the critical stretch, above 1
  double excess = 0.0;  // its energy minus that at the scene's critical stretch, c dx5
};

// In dx, without the state's origin.
NodeVectors displacements_of(const State& state);

// Compression (g < 0) reduces the stiffness across a bond, so the exact tangent may have motions of
// negative stiffness. The positive tangent omits that term; its error is at most of the order of
// the stretch (src/solver/README.md 8.1).
enum class Tangent { exact, positive };

struct Stretches {
  double max = 0.0;                   // the largest ratio of all bonds
  std::vector<Overstretched> beyond;  // ordered by place and bit
};

class LinearisedBonds {
 public:
  // Takes the intact bonds of `state`, with the thermal strain `heat` (by Grid::index; empty means
  // 0). All arguments must outlive the object.
  LinearisedBonds(const Lattice& lattice, const State& state, Threads threads,
                  std::span<const double> heat = {});

  const NodeLayout& layout() const { return state_->layout; }
  const Lattice& lattice() const { return *lattice_; }
  const Threads& threads() const { return threads_; }

  bool has_bonds(int i, int j) const;
  // Calls work(k, l) for every node (k, l) joined to node (i, j) by an intact bond.
  template <class Work>
  void for_each_neighbour(int i, int j, const Work& work) const {
    for (const Kept& bond : kept_) {
      if (holds(i, j, bond)) work(i + bond.a, j + bond.b);
      const int k = i - bond.a, l = j - bond.b;
      if (lattice_->grid.contains(k, l) && holds(k, l, bond)) work(k, l);
    }
  }

  // Computes the force of all bonds on every node.
  void forces(const NodeVectors& u, NodeVectors& force) const;

  // Computes the tangent at u: c w/L (g 1 + (1+e)^(-3/2) y y^T/L^2) of each bond, with y = xi + h.
  // Stored in single precision.
  void linearise(const NodeVectors& u, Tangent tangent);
  // Removes bonds that have broken since then from the tangent.
  void forget(const std::vector<BrokenBond>& broken_bonds);
  // Computes the first-order change of the forces when u changes by p. Requires linearise().
  void apply_row(const NodeVectors& p, NodeVectors& result, int j) const;
  // Calls work(one, other, stiffness) for every intact bond; ends by Grid::index.
  template <class Work>
  void for_each_stiffness(const Work& work) const {
    const Grid& grid = lattice_->grid;
    for (int j = 0; j < grid.ny; ++j)
      for (std::size_t k = 0; k < kept_.size(); ++k) {
        const float *xx = slice(j, k, 0), *xy = slice(j, k, 1), *yy = slice(j, k, 2);
        for (int i = 0; i < grid.nx; ++i) {
          if (!holds(i, j, kept_[k])) continue;
          const std::ptrdiff_t at = layout().at(i, 0);
          work(grid.index(i, j), grid.index(i + kept_[k].a, j + kept_[k].b),
               Stiffness{xx[at], xy[at], yy[at]});
        }
      }
  }
  // Returns the sum of the stiffnesses of a node's bonds.
  Stiffness own_stiffness(int i, int j) const;

  // Returns the critical stretch of every node, by Grid::index: if its material has a history,
  // moved by the smallest stretch of its bonds at u (paper Eq. 11). A bond breaks at the smaller
  // value of its ends.
  std::vector<double> critical_stretches(const NodeVectors& u) const;
  // Returns the bonds above that stretch, without those of no-fail zones.
  Stretches stretches(const NodeVectors& u) const;

  // Returns the unit of force density, c dx^2, in N/m3.
  double unit_of_force() const { return unit_; }

 private:
  // A bond kept by a node, or the image of one that another node keeps.
  struct Kept {
    int a, b;
    Vec2 xi;
    double weight, inverse_length;
    int bit;
  };

  bool holds(int i, int j, const Kept& bond) const;
  // Returns the weight times the mean micromodulus of both ends, over that of the plate's own
  // material.
  double strength_of(int i, int j, const Kept& bond) const;
  double heat_of(int i, int j, const Kept& bond) const;
  double critical_stretch(const NodeVectors& u, int i, int j) const;
  void pull_row(const NodeVectors& u, int j, const Kept& bond, bool keeps, double* x,
                double* y) const;
  void add_stretches_of_row(const NodeVectors& u, const std::vector<double>& critical, int j,
                            Stretches& sum) const;
  double stretch_of(const NodeVectors& u, int i, int j, const Kept& bond) const;
  Stiffness stiffness_of(const NodeVectors& u, int i, int j, const Kept& bond,
                         Tangent tangent) const;
  void linearise_row(const NodeVectors& u, Tangent tangent, int j);
  void sum_own_row(int j);
  // Columns of one component of one bond in a row; zeros beyond the plate.
  float* slice(int j, std::size_t bond, int component);
  const float* slice(int j, std::size_t bond, int component) const;

  const Lattice* lattice_;
  const State* state_;
  Threads threads_;
  std::span<const double> heat_;
  double unit_;
  std::vector<Kept> kept_;
  std::vector<std::size_t> images_;  // first of kept_ of each class of mirror images
  std::vector<float> tangent_;
  std::vector<float> zeros_;
  std::vector<Stiffness> own_;  // per node
};

}  // namespace hackle
