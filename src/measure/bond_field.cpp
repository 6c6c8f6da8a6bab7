// SPDX-License-Identifier: MIT
#include "measure/bond_field.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

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

// Adds zz of a plate that cannot strain across its thickness.
void add_stress_across(const View& view, std::vector<Stress>& stresses) {
  const Lattice& lattice = view.lattice();
  const std::vector<double>& heat = view.thermal_strain();
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i) {
      if (lattice.is_void(i, j)) continue;
      const std::size_t node = lattice.grid.index(i, j);
      const Moduli& moduli = lattice.material_at(i, j).calibration.moduli;
      Stress& own = stresses[node];
      own.zz = moduli.nu * (own.xx + own.yy) - moduli.E * (heat.empty() ? 0.0 : heat[node]);
    }
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
  const double unit = 0.5 * std::pow(grid.dx, 3);  // from 1/2 |xi| V
  visit_bonds(view, [&](const VisitedBond& bond) {
    if (!bond.holds) return;
    const double pull = unit * bond.c * bond.weight * bond.s / bond.length;
    const Vec2 along = pull * bond.xi;
    for (const std::size_t node : {bond.one, bond.other}) {
      stresses[node].xx += along.x() * bond.xi.x();
      stresses[node].yy += along.y() * bond.xi.y();
      stresses[node].xy += along.x() * bond.xi.y();
    }
  });
  if (view.plate().plane == Plane::strain) add_stress_across(view, stresses);
  return stresses;
}

std::vector<double> energy_densities(const View& view) {
  const Grid& grid = view.lattice().grid;
  std::vector<double> densities(grid.nodes());
  const double unit = 0.25 * std::pow(grid.dx, 3);  // from 1/2 c s^2/2 |xi| V
  visit_bonds(view, [&](const VisitedBond& bond) {
    const double density = unit * bond.c * bond.weight * bond.length * bond.s * bond.s;
    densities[bond.one] += density;
    densities[bond.other] += density;
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
