// SPDX-License-Identifier: MIT
// Fields that follow from a node's bonds: stress, energy, closeness to breaking. Values are by
// Grid::index, 0 where no bond holds. Within a horizon of an edge or a crack a node lacks bonds;
// its stress is that of the bonds it has.
#pragma once

#include <vector>

#include "solver/view.hpp"

namespace hackle {

// Pa. The stress across the plate, zz, is 0 in plane stress; in plane strain it is nu (xx + yy) - E
// th by Hooke's law, with the moduli of the node's material on the lattice and th its thermal
// strain.
struct Stress {
  double xx = 0.0, yy = 0.0, xy = 0.0;
  double zz = 0.0;

  double first() const;   // the larger principal stress in the plate
  double second() const;  // the smaller
  double shear() const;   // the largest in the plane: half their difference
  double von_mises() const;
};

// sigma = 1/2 sum over its bonds of c w s |xi| (e x e) V, the derivative of the energy density by a
// uniform small strain; e the direction of the bond at rest.
std::vector<Stress> stresses(const View& view);

// J/m3: each end of a bond has half of its energy.
std::vector<double> energy_densities(const View& view);

// The largest s/s0 of the bonds that hold; below 0 where all are compressed.
std::vector<double> closest_to_breaking(const View& view);

// Which fragment of the plate each node belongs to: 1 for the one with the most nodes, and so on; 0
// where no bond holds. Of fragments alike, the one that begins nearer to the lower left corner is
// first.
std::vector<int> fragment_numbers(const View& view);

}  // namespace hackle
