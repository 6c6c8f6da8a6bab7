// SPDX-License-Identifier: MIT
// A lattice in the kernel's terms: everything that does not change from step to step.
#pragma once

#include <vector>

#include "lattice/lattice.hpp"
#include "solver/kernel.hpp"

namespace hackle {

// (1 + s)^2 - 1: the e at a stretch.
double threshold_of(double stretch);

// One entry for each offset of the family, in its order, for time steps of dt seconds. `varied`:
// the critical stretch is not the same everywhere.
template <class Real>
std::vector<BondClass<Real>> bond_classes(const Lattice& lattice, double dt, bool varied);

template <class Real>
std::vector<NodeLoad<Real>> node_loads(const Lattice& lattice, double dt);

// The first of these loads in every row of nodes, and their number.
std::vector<std::size_t> first_load_of_rows(const Lattice& lattice);

template <class Real>
BoundFactors<Real> bound_factors(const Family& family);

template <class Real>
LinearStencil<Real> linear_stencil(const std::vector<BondClass<Real>>& classes);

}  // namespace hackle
