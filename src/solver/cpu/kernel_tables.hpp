// SPDX-License-Identifier: MIT
// A lattice in the kernel's terms: everything that does not change from step to step.
#pragma once

#include <vector>

#include "lattice/lattice.hpp"
#include "solver/actions.hpp"
#include "solver/cpu/kernel.hpp"

namespace hackle {

// Returns (1 + s)^2 - 1, the e at a stretch.
double threshold_of(double stretch);

// Makes one entry per offset of the family, in its order, for time steps of dt seconds. `varied`:
// the critical stretch is not uniform.
template <class Real>
std::vector<BondClass<Real>> bond_classes(const Lattice& lattice, double dt, bool varied);

// Keeps the given order. `unit` converts from m/s2 to lattice units of acceleration: dt^2/dx.
template <class Real>
std::vector<NodeLoad<Real>> node_loads(const std::vector<LoadedNode>& forces, double unit);
template <class Real>
std::vector<PrescribedMotion<Real>> prescribed_motions(
    const std::vector<PrescribedNode>& prescribed);

// Returns, for every row, the index of its first node in the list, then the number of nodes.
template <class Node>
std::vector<std::size_t> first_of_rows(const std::vector<Node>& nodes, int rows) {
  std::vector<std::size_t> first;
  first.reserve(static_cast<std::size_t>(rows) + 1);
  std::size_t at = 0;
  for (int j = 0; j <= rows; ++j) {
    while (at < nodes.size() && nodes[at].j < j) ++at;
    first.push_back(at);
  }
  return first;
}

template <class Real>
BoundFactors<Real> bound_factors(const Family& family);

template <class Real>
LinearStencil<Real> linear_stencil(const std::vector<BondClass<Real>>& classes);

}  // namespace hackle
