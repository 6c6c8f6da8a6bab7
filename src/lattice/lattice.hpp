// SPDX-License-Identifier: MIT
// The scene on a square lattice: everything that does not change while it is solved.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "lattice/bonds.hpp"
#include "lattice/calibration.hpp"
#include "lattice/family.hpp"
#include "lattice/grid.hpp"

namespace hackle {

// A material with its constants calibrated for this lattice.
struct MaterialOnLattice {
  Material material;
  Calibration calibration;
};

// The plate's own material first, then those of its inclusions, each once.
std::vector<MaterialOnLattice> materials_of(const Plate& plate, const Family& family,
                                            const Numerics& numerics);
// Whether any two differ in micromodulus, density, critical stretch or alpha.
bool differ(const std::vector<MaterialOnLattice>& materials);
// Whether any has an alpha above 0.
bool have_history(const std::vector<MaterialOnLattice>& materials);

// Of all bonds that node (i, j) keeps, the one of `bit` (see Family).
struct KeptBond {
  int i = 0;
  int j = 0;
  int bit = 0;
};

struct Lattice {
  Lattice(const Plate& plate, const Numerics& numerics);

  Grid grid;
  Family family;
  // The plate's own material first, then those of its inclusions. A bond between two has the mean
  // of their micromoduli, and breaks by the weaker.
  std::vector<MaterialOnLattice> materials;
  std::vector<std::uint8_t>
      material;             // per node: of `materials`, or void_node; empty when all are 0
  Calibration calibration;  // of the plate's own material
  double rho;               // kg/m3, of the plate's own material
  double step_limit;        // s, see step_limit() below, of the plate as it was described
  BondBits bonds;           // at t = 0, after the cracks were cut
  std::vector<std::uint16_t> initial_neighbours;  // per node: initial bonds, the base of its damage
  std::vector<KeptBond> cut;    // by cracks, broken and absent; empty where the plate has no
                                // contact, which alone asks for them
  BondBits unbreakable;         // bonds of no-fail zones; empty when there are none
  std::vector<float> strength;  // per node: its critical stretch over s0; empty when all are 1

  // Marks nodes that cut-outs removed: they have no bonds, loads or motion.
  static constexpr std::uint8_t void_node = hackle::void_node;
  bool is_void(int i, int j) const {
    return !material.empty() && material[grid.index(i, j)] == void_node;
  }
  // The material of a node that is not void.
  const MaterialOnLattice& material_at(int i, int j) const {
    return material.empty() ? materials.front() : materials[material[grid.index(i, j)]];
  }
  // Constants of node (i, j); those of the plate's own material where it is void. A bond has the
  // mean of the micromoduli of its nodes and breaks by the lesser critical stretch.
  double micromodulus_at(int i, int j) const;
  double critical_stretch_at(int i, int j) const;  // strength included
  bool is_mixed() const { return differ(materials); }
  bool has_history() const { return have_history(materials); }
  double min_stretch() const;  // the least critical stretch of all materials
  std::int64_t initial_bonds() const;
};

// Calls visit(const KeptBond&) for every bond that is in `all` and not in `left`.
template <class Visit>
void for_each_missing(const BondBits& all, const BondBits& left, const Lattice& lattice,
                      Visit visit) {
  const NodeLayout layout = lattice.grid.layout();
  for (int word = 0; word < lattice.family.words(); ++word)
    for (int j = 0; j < lattice.grid.ny; ++j)
      for (int i = 0; i < lattice.grid.nx; ++i)
        for (std::uint32_t missing =
                 all.word(layout.at(i, j), word) & ~left.word(layout.at(i, j), word);
             missing != 0; missing &= missing - 1)
          visit(KeptBond{i, j, 32 * word + std::countr_zero(missing)});
}

// The limit of the step, s: 2/omega_max of the stiffest and the lightest material, contacts and
// impacts of `plate` included. Damping does not change it (see solver/damping.hpp).
double step_limit(const Lattice& lattice, const Plate& plate);

// The number of bonds per node among `bonds`, in the order of Grid::index.
std::vector<std::uint16_t> degrees(const Grid& grid, const Family& family, const BondBits& bonds);

// Whether the bond of node (i, j) to (i + column, j + row) holds; false when there is none.
bool holds(const Grid& grid, const Family& family, const BondBits& bonds, int i, int j, int column,
           int row);

// Breaks all bonds of a node.
void isolate(const Grid& grid, const Family& family, int i, int j, BondBits& bonds);

}  // namespace hackle
