// SPDX-License-Identifier: MIT
#include "solver/bond_visit.hpp"

namespace hackle {

NodeShares node_shares(const Lattice& lattice, const State& state,
                       const std::vector<double>& heat) {
  NodeShares nodes{{}, {}, heat, {}};
  nodes.heat.resize(lattice.grid.nodes());
  nodes.c.reserve(lattice.grid.nodes());
  nodes.s0.reserve(lattice.grid.nodes());
  nodes.u.reserve(lattice.grid.nodes());
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i) {
      nodes.c.push_back(lattice.micromodulus_at(i, j));
      nodes.s0.push_back(lattice.critical_stretch_at(i, j));
      nodes.u.push_back(state.u(i, j));
    }
  return nodes;
}

}  // namespace hackle
