// SPDX-License-Identifier: MIT
#include "measure/bond_field.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "base/union_find.hpp"
#include "solver/bond_visit.hpp"

namespace hackle {
namespace {

template <class Visit>
void visit_bonds(const View& view, Visit visit) {
  hackle::visit_bonds(view.lattice(), view.state(), view.thermal_strain(), visit);
}

// Returns, for each node, the first node of its fragment.
std::vector<std::size_t> first_nodes(const View& view) {
  UnionFind fragments(view.lattice().grid.nodes());
  visit_bonds(view, [&](const VisitedBond& bond) {
    if (bond.holds) fragments.unite(bond.one, bond.other);
  });
  return fragments.firsts();
}

double unit_of_stress(const Grid& grid) {
  return 0.5 * std::pow(grid.dx, 3);  // from 1/2 |xi| V
}
double unit_of_energy(const Grid& grid) {
  return 0.25 * std::pow(grid.dx, 3);  // from 1/2 c s^2/2 |xi| V
}

// Sets zz of a node of a plate that cannot strain across its thickness.
void set_stress_across(const View& view, int i, int j, Stress& stress) {
  const Lattice& lattice = view.lattice();
  if (view.plate().plane != Plane::strain || lattice.is_void(i, j)) return;
  const std::vector<double>& heat = view.thermal_strain();
  const Moduli& moduli = lattice.material_at(i, j).calibration.moduli;
  const double strain = heat.empty() ? 0.0 : heat[lattice.grid.index(i, j)];
  stress.zz = moduli.nu * (stress.xx + stress.yy) - moduli.E * strain;
}

// Adds the share of a bond that holds to the stress of one of its ends.
void add_stress(const VisitedBond& bond, double unit, Stress& stress) {
  const double pull = unit * bond.c * bond.weight * bond.s / bond.length;
  stress.xx += pull * bond.xi.x() * bond.xi.x();
  stress.yy += pull * bond.xi.y() * bond.xi.y();
  stress.xy += pull * bond.xi.x() * bond.xi.y();
}

// Returns the energy of a bond at each of its ends, J/m3.
double energy_density(const VisitedBond& bond, double unit) {
  return unit * bond.c * bond.weight * bond.length * bond.s * bond.s;
}

}  // namespace

double Stress::first() const {
  return 0.5 * (xx + yy) + shear();
}
double Stress::second() const {
  return 0.5 * (xx + yy) - shear();
}
double Stress::shear() const {
  return std::hypot(0.5 * (xx - yy), xy);
}
double Stress::von_mises() const {
  return std::sqrt(
      std::max(0.0, xx * xx - xx * yy + yy * yy + zz * (zz - xx - yy) + 3.0 * xy * xy));
}

std::vector<Stress> stresses(const View& view) {
  const Grid& grid = view.lattice().grid;
  std::vector<Stress> stresses(grid.nodes());
  const double unit = unit_of_stress(grid);
  visit_bonds(view, [&](const VisitedBond& bond) {
    if (!bond.holds) return;
    for (const std::size_t node : {bond.one, bond.other}) add_stress(bond, unit, stresses[node]);
  });
  if (view.plate().plane == Plane::strain)
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) set_stress_across(view, i, j, stresses[grid.index(i, j)]);
  return stresses;
}

std::vector<double> energy_densities(const View& view) {
  const Grid& grid = view.lattice().grid;
  std::vector<double> densities(grid.nodes());
  const double unit = unit_of_energy(grid);
  visit_bonds(view, [&](const VisitedBond& bond) {
    for (const std::size_t node : {bond.one, bond.other})
      densities[node] += energy_density(bond, unit);
  });
  return densities;
}

std::vector<double> closest_to_breaking(const View& view) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  std::vector<double> shares(view.lattice().grid.nodes(), none);
  visit_bonds(view, [&](const VisitedBond& bond) {
    if (!bond.holds) return;
    for (const std::size_t node : {bond.one, bond.other})
      shares[node] = std::max(shares[node], bond.s / bond.s0);
  });
  std::ranges::replace(shares, none, 0.0);
  return shares;
}

BondsOfNode bonds_of_node(const View& view, int i, int j) {
  const Grid& grid = view.lattice().grid;
  const double stress = unit_of_stress(grid), energy = unit_of_energy(grid);
  BondsOfNode found;
  std::optional<double> closest;
  visit_bonds_of(i, j, view.lattice(), view.state(), view.thermal_strain(),
                 [&](const VisitedBond& bond) {
                   if (!bond.holds) return;
                   add_stress(bond, stress, found.stress);
                   found.energy += energy_density(bond, energy);
                   closest = std::max(closest.value_or(bond.s / bond.s0), bond.s / bond.s0);
                 });
  set_stress_across(view, i, j, found.stress);
  found.closeness = closest.value_or(0.0);
  return found;
}

std::vector<int> fragment_numbers(const View& view) {
  const std::vector<std::size_t> first = first_nodes(view);
  std::vector<int> sizes(first.size());
  for (const std::size_t node : first) ++sizes[node];
  std::vector<std::size_t> fragments;
  for (std::size_t node = 0; node < first.size(); ++node)
    if (sizes[node] > 1) fragments.push_back(node);
  std::ranges::stable_sort(fragments, std::greater(),
                           [&](std::size_t node) { return sizes[node]; });
  std::vector<int> rank(first.size());
  for (std::size_t k = 0; k < fragments.size(); ++k) rank[fragments[k]] = static_cast<int>(k) + 1;
  std::vector<int> numbers(first.size());
  std::ranges::transform(first, numbers.begin(), [&](std::size_t node) { return rank[node]; });
  return numbers;
}

}  // namespace hackle
