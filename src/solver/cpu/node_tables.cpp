// SPDX-License-Identifier: MIT
#include "solver/cpu/node_tables.hpp"

#include "lattice/carve.hpp"
#include "solver/cpu/kernel_tables.hpp"

namespace hackle {

template <class Real>
NodeTables<Real>::NodeTables(const Lattice& lattice, const KernelFeatures& features)
    : alpha(static_cast<Real>(lattice.materials.front().material.alpha)),
      min_threshold(static_cast<Real>(threshold_of(lattice.calibration.s0))) {
  if (features.varied) set_thresholds(lattice, features.mixed);
  if (features.mixed) set_materials(lattice, features.history);
}

template <class Real>
void NodeTables<Real>::set_thresholds(const Lattice& lattice, bool mixed) {
  const NodeLayout layout = lattice.grid.layout();
  s00.assign(layout.size(), static_cast<Real>(lattice.calibration.s0));
  threshold.assign(layout.size(), min_threshold);
  if (lattice.strength.empty() && !mixed) return;
  for_nodes(lattice.grid, [&](int i, int j) {
    const auto at = static_cast<std::size_t>(layout.at(i, j));
    const double own = lattice.critical_stretch_at(i, j);
    s00[at] = static_cast<Real>(own);
    threshold[at] = static_cast<Real>(threshold_of(own));
  });
}

// Places without a node have no bonds, so any number will do.
template <class Real>
void NodeTables<Real>::set_materials(const Lattice& lattice, bool history) {
  const NodeLayout layout = lattice.grid.layout();
  half_stiffness.assign(layout.size(), Real{0.5});
  inverse_inertia.assign(layout.size(), Real{1});
  if (history) alphas.assign(layout.size(), Real{0});
  for_nodes(lattice.grid, [&](int i, int j) {
    if (lattice.is_void(i, j)) return;
    const MaterialOnLattice& own = lattice.material_at(i, j);
    const auto at = static_cast<std::size_t>(layout.at(i, j));
    half_stiffness[at] =
        static_cast<Real>(0.5 * lattice.micromodulus_at(i, j) / lattice.calibration.c);
    inverse_inertia[at] = static_cast<Real>(lattice.rho / own.material.rho);
    if (history) alphas[at] = static_cast<Real>(own.material.alpha);
  });
}

template <class Real>
std::size_t NodeTables<Real>::bytes() const {
  return bytes_of(s00) + bytes_of(threshold) + bytes_of(half_stiffness) +
         bytes_of(inverse_inertia) + bytes_of(alphas);
}

template struct NodeTables<float>;
template struct NodeTables<double>;

}  // namespace hackle
