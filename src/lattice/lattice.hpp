// SPDX-License-Identifier: MIT
// The scene on a square lattice: everything that stays constant during a run.
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

// Returns the plate's own material first, then those of its inclusions, each once.
std::vector<MaterialOnLattice> materials_of(const Plate& plate, const Family& family,
                                            const Numerics& numerics);
// Returns whether any two differ in micromodulus, density, critical stretch or alpha.
bool differ(const std::vector<MaterialOnLattice>& materials);
// Returns whether any has an alpha above 0.
bool have_history(const std::vector<MaterialOnLattice>& materials);

// The bond with bit `bit` (see Family) among those that node (i, j) keeps.
struct KeptBond {
  int i = 0;
  int j = 0;
  int bit = 0;
};

struct Lattice {
  Lattice(const Plate& plate, const Numerics& numerics);

  Grid grid;
  Family family;
  // The plate's own material first, then those of its inclusions. A bond between two materials has
  // the mean of their micromoduli and breaks at the smaller critical stretch.
  std::vector<MaterialOnLattice> materials;
  std::vector<std::uint8_t>
      material;             // per node: index in `materials`, or void_node; empty if all are 0
  Calibration calibration;  // of the plate's own material
  double rho;               // kg/m3, of the plate's own material
  double step_limit;        // s, see step_limit() below, for the plate as described
  BondBits bonds;           // at t = 0, after the cracks were cut
  // per node: number of initial bonds, to which damage is relative
  std::vector<std::uint16_t> initial_neighbours;
  std::vector<KeptBond> cut;    // by cracks, broken or absent; empty without contact,
                                // which alone needs them
  BondBits unbreakable;         // bonds of no-fail zones; empty when there are none
  std::vector<float> strength;  // per node: its critical stretch over s0; empty when all are 1
  std::vector<float> surface;   // per node: factor of its micromodulus (surface.hpp); empty when
                                // all are 1

  // Marks nodes removed by cut-outs: they have no bonds, loads or motion.
  static constexpr std::uint8_t void_node = hackle::void_node;
  bool is_void(int i, int j) const {
    return !material.empty() && material[grid.index(i, j)] == void_node;
  }
  // Returns the material of a node that is not void.
  const MaterialOnLattice& material_at(int i, int j) const {
    return material.empty() ? materials.front() : materials[material[grid.index(i, j)]];
  }
  // Return the constants of node (i, j), or those of the plate's own material if it is void. A bond
  // has the mean micromodulus of its two nodes and breaks at the smaller critical stretch.
  double micromodulus_at(int i, int j) const;      // correction of surfaces included
  double critical_stretch_at(int i, int j) const;  // strength included
  bool is_mixed() const { return !surface.empty() || differ(materials); }  // of unlike nodes
  bool has_history() const { return have_history(materials); }
  double min_stretch() const;  // smallest critical stretch of all materials
  std::int64_t initial_bonds() const;
  std::size_t bytes() const;  // that grow with the plate
};

// Calls visit(const KeptBond&) for every bond that is in `all` but not in `left`.
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

// Computes the limit of the time step, s: 2/omega_max with the stiffest and the lightest material,
// including contacts and impacts of `plate`. Damping does not change it (see
// solver/terms/damping.hpp).
double step_limit(const Lattice& lattice, const Plate& plate);

// Returns the number of bonds per node among `bonds`, in the order of Grid::index.
std::vector<std::uint16_t> degrees(const Grid& grid, const Family& family, const BondBits& bonds);

// Returns whether the bond of node (i, j) to (i + column, j + row) is intact; false if there is
// none.
bool holds(const Grid& grid, const Family& family, const BondBits& bonds, int i, int j, int column,
           int row);

// Breaks all bonds of a node.
void isolate(const Grid& grid, const Family& family, int i, int j, BondBits& bonds);

}  // namespace hackle
