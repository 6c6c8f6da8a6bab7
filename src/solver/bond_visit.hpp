// SPDX-License-Identifier: MIT
// Visits every initial bond, or those of one node, with its stretch, for per-bond diagnostics.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "lattice/lattice.hpp"
#include "solver/state.hpp"

namespace hackle {

struct VisitedBond {
  std::size_t one = 0, other = 0;  // its nodes, by Grid::index
  Vec2 xi{0, 0};                   // from one to the other, in units of dx
  Vec2 h{0, 0};                    // relative displacement, in units of dx; 0 if it is broken
  double length = 0.0;             // of xi
  double weight = 0.0;             // from its quadrature
  double c = 0.0;                  // micromodulus, N/m6
  double s0 = 0.0;                 // critical stretch
  double s = 0.0;                  // stretch without the thermal part; 0 if it is broken
  bool holds = true;
};

// Computes s from the relative displacement h of a bond xi, in units of dx, without cancellation.
// `per_length2` is 1/|xi|^2, the same for all bonds of an offset; `heat` is the thermal part of e =
// (1 + s)^2 - 1.
inline double stretch(const Vec2& xi, double per_length2, const Vec2& h, double heat) {
  const double e = h.dot(h + 2.0 * xi) * per_length2 - heat;
  return e / (1.0 + std::sqrt(std::max(1.0 + e, 0.0)));
}

// Calls visit(const VisitedBond&) once for every initial bond that for_keepers(a, b, each) finds:
// it calls each(i, j) for nodes that may keep a bond of the offset (a, b).
template <class ForKeepers, class Visit>
void visit_bonds_kept(const Lattice& lattice, const State& state, const std::vector<double>& heat,
                      ForKeepers for_keepers, Visit visit) {
  const bool alike = lattice.material.empty() && lattice.surface.empty();
  const bool even = lattice.material.empty() && lattice.strength.empty();
  const auto heat_of = [&](std::size_t node) { return heat.empty() ? 0.0 : heat[node]; };
  const auto with = [&](const auto& motion, int a, int b, const Vec2& xi, double weight, int bit) {
    const auto u = [&](std::ptrdiff_t at) {
      const auto place = static_cast<std::size_t>(at);
      return Vec2(motion.ux[place], motion.uy[place]);
    };
    const std::ptrdiff_t way = b * state.layout.stride() + a;
    const double per_length2 = 1.0 / xi.squaredNorm();
    VisitedBond bond;
    bond.xi = xi;
    bond.length = xi.norm();
    bond.weight = weight;
    bond.c = lattice.calibration.c;
    bond.s0 = lattice.calibration.s0;
    for_keepers(a, b, [&](int i, int j) {
      const std::ptrdiff_t at = state.layout.at(i, j);
      if (!lattice.bonds.holds(at, bit)) return;
      bond.one = lattice.grid.index(i, j);
      bond.other = lattice.grid.index(i + a, j + b);
      if (!alike)
        bond.c = 0.5 * (lattice.micromodulus_at(i, j) + lattice.micromodulus_at(i + a, j + b));
      if (!even)
        bond.s0 =
            std::min(lattice.critical_stretch_at(i, j), lattice.critical_stretch_at(i + a, j + b));
      bond.holds = state.bonds.holds(at, bit);
      bond.h = bond.holds ? u(at + way) - u(at) : Vec2(0, 0);
      bond.s = bond.holds
                   ? stretch(xi, per_length2, bond.h, heat_of(bond.one) + heat_of(bond.other))
                   : 0.0;
      visit(static_cast<const VisitedBond&>(bond));
    });
  };
  std::visit(
      [&](const auto& motion) {
        lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
          with(motion, a, b, xi, weight, bit);
        });
      },
      state.motion);
}

// Calls visit(const VisitedBond&) once for every initial bond, in a fixed order. `heat` is the
// thermal strain by Grid::index; empty means 0. Takes no memory that grows with the plate.
template <class Visit>
void visit_bonds(const Lattice& lattice, const State& state, const std::vector<double>& heat,
                 Visit visit) {
  const auto all = [&](int, int, const auto& each) {
    for (int j = 0; j < lattice.grid.ny; ++j)
      for (int i = 0; i < lattice.grid.nx; ++i) each(i, j);
  };
  visit_bonds_kept(lattice, state, heat, all, visit);
}

// The same for the bonds of node (i, j), in the same order; costs as little as they are few.
template <class Visit>
void visit_bonds_of(int i, int j, const Lattice& lattice, const State& state,
                    const std::vector<double>& heat, Visit visit) {
  const Grid& grid = lattice.grid;
  const auto both = [&](int a, int b, const auto& each) {
    for (const auto& [x, y] : {std::pair(i - a, j - b), std::pair(i, j)})
      if (x >= 0 && x < grid.nx && y >= 0 && y < grid.ny) each(x, y);
  };
  visit_bonds_kept(lattice, state, heat, both, visit);
}

}  // namespace hackle
