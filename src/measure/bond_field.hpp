// SPDX-License-Identifier: MIT
// Fields that follow from a node's bonds: stress, energy, closeness to breaking. Values are by
// Grid::index, 0 for nodes without intact bonds. Within a horizon of an edge or a crack a node
// lacks bonds; its stress is that of its remaining bonds.
#pragma once

#include <vector>

#include "solver/view.hpp"

namespace hackle {

// Pa. The stress across the plate, zz, is 0 in plane stress; in plane strain it is nu (xx + yy) - E
// th by Hooke's law, with the moduli of the node's material on the lattice and its thermal strain
// th.
struct Stress {
  double xx = 0.0, yy = 0.0, xy = 0.0;
  double zz = 0.0;

  double first() const;   // the larger principal stress in the plate
  double second() const;  // the smaller
  double shear() const;   // largest in-plane shear: half their difference
  double von_mises() const;
};

// Computes sigma = 1/2 sum over its bonds of c w s |xi| (e x e) V, the derivative of the energy
// density by a uniform small strain; e is the direction of the undeformed bond.
std::vector<Stress> stresses(const View& view);

// Computes J/m3; each end of a bond has half of its energy.
std::vector<double> energy_densities(const View& view);

// Computes the largest s/s0 of the intact bonds; below 0 where all are compressed.
std::vector<double> closest_to_breaking(const View& view);

// What the bonds of one node say, as above, without looking at any other bond.
struct BondsOfNode {
  Stress stress;
  double energy = 0.0;     // J/m3
  double closeness = 0.0;  // largest s/s0
};
BondsOfNode bonds_of_node(const View& view, int i, int j);

// Returns the number of the fragment of each node: 1 for the fragment with the most nodes, and so
// on; 0 for nodes without intact bonds. Of equal fragments, the one that begins nearer to the lower
// left corner comes first.
std::vector<int> fragment_numbers(const View& view);

}  // namespace hackle
