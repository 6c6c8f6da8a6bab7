// SPDX-License-Identifier: MIT
#include "solver/terms/crack_faces.hpp"

#include <algorithm>

#include "lattice/touching.hpp"
#include "solver/bond_visit.hpp"
#include "solver/terms/roughness.hpp"

namespace hackle {
namespace {

// The stretch above which a lost bond has no weight. A smaller limit would press faces that slide:
// lengthened bonds would count too little against shortened ones.
constexpr double gone = 4.0;

// Returns the weighted s, and its derivative.
double counted(double s) {
  if (s <= 0.0) return s;
  const double left = std::max(1.0 - s / gone, 0.0);
  return s * left * left;
}
double counted_slope(double s) {
  if (s <= 0.0) return 1.0;
  return std::max(1.0 - s / gone, 0.0) * (1.0 - 3.0 * s / gone);
}

const OpenNode& at(std::span<const OpenNode> nodes, int place) {
  return nodes[static_cast<std::size_t>(place)];
}

}  // namespace

CrackFaces::CrackFaces(const Lattice& lattice, double dt)
    : horizon_(lattice.family.m()),
      strength_(faces_bear * lattice.calibration.c * lattice.grid.dx * dt * dt / lattice.rho),
      offsets_(static_cast<std::size_t>(32 * lattice.family.words())) {
  lattice.family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
    offsets_[static_cast<std::size_t>(bit)] = {{a, b}, xi, xi.norm(), weight};
  });
}

void CrackFaces::clear() {
  bonds_.clear();
  near_.clear();
  stiffness_.clear();
}

void CrackFaces::lose(const Lattice& lattice, std::span<const OpenNode> nodes, int one, int other,
                      int bit) {
  const OpenNode &p = at(nodes, one), &q = at(nodes, other);
  const double c = 0.5 * (lattice.micromodulus_at(p.i, p.j) + lattice.micromodulus_at(q.i, q.j));
  LostBond bond{one, other, bit};
  bond.pull = offset_of(bond).weight * c / lattice.calibration.c;
  bond.stiffness = 0.5 * bond.pull * offset_of(bond).length / horizon_;
  near_.push_back(static_cast<int>(bonds_.size()));
  bonds_.push_back(bond);
  stiffness_.resize(nodes.size());
  for (const int end : {one, other})
    stiffness_[static_cast<std::size_t>(end)].add({bond.stiffness, 0.0});
}

void CrackFaces::find_near(std::span<const OpenNode> nodes, double slack) {
  near_.clear();
  for (int place = 0; place < static_cast<int>(bonds_.size()); ++place) {
    const LostBond& bond = bonds_[static_cast<std::size_t>(place)];
    const double apart = (at(nodes, bond.other).home - at(nodes, bond.one).home).norm();
    if (apart < (1.0 + gone) * offset_of(bond).length + 2.0 * slack) near_.push_back(place);
  }
}

double CrackFaces::stretch_of(const LostBond& bond, std::span<const OpenNode> nodes,
                              const std::vector<double>& heat) const {
  const Offset& offset = offset_of(bond);
  const OpenNode &p = at(nodes, bond.one), &q = at(nodes, bond.other);
  const double warmth = heat.empty() ? 0.0 : heat[p.index] + heat[q.index];
  return stretch(offset.xi, 1.0 / (offset.length * offset.length), q.u - p.u, warmth);
}

bool CrackFaces::find_closed(std::span<const OpenNode> nodes,
                             const std::vector<double>& heat) const {
  stretches_.clear();
  nearing_.assign(stiffness_.size(), {});
  for (const int place : near_) {
    const LostBond& bond = bonds_[static_cast<std::size_t>(place)];
    const double s = stretches_.emplace_back(stretch_of(bond, nodes, heat));
    const Vec2 nearer(bond.stiffness * counted(s), 0.0);
    if (nearer.x() == 0.0) continue;
    for (const int end : {bond.one, bond.other})
      nearing_[static_cast<std::size_t>(end)].add(nearer);
  }
  approach_.assign(nodes.size(), 0.0);
  bool closed = false;
  for (std::size_t node = 0; node < nearing_.size(); ++node) {
    const double nearer = nearing_[node].value().x();
    if (!(nearer < 0.0)) continue;
    approach_[node] = nearer / stiffness_[node].value().x();
    closed = true;
  }
  return closed;
}

double CrackFaces::stored() const {
  OrderFreeSum sum;
  for (std::size_t node = 0; node < nearing_.size(); ++node)
    sum.add({0.5 * stiffness_[node].value().x() * approach_[node] * approach_[node], 0.0});
  return strength_ * horizon_ * sum.value().x();
}

double CrackFaces::energy(std::span<const OpenNode> nodes, const std::vector<double>& heat) const {
  return find_closed(nodes, heat) ? stored() : 0.0;
}

double CrackFaces::approach_of(const LostBond& bond) const {
  return 0.5 * (approach_[static_cast<std::size_t>(bond.one)] +
                approach_[static_cast<std::size_t>(bond.other)]);
}

Vec2 CrackFaces::force_of(const LostBond& bond, std::span<const OpenNode> nodes, double s) const {
  const double eps = approach_of(bond);
  const Offset& offset = offset_of(bond);
  const Vec2 y = offset.xi + (at(nodes, bond.other).u - at(nodes, bond.one).u);
  return (strength_ * bond.pull * counted_slope(s) * eps / (offset.length * (1.0 + s))) * y;
}

double CrackFaces::push(std::span<OpenNode> nodes, const std::vector<double>& heat,
                        double friction) {
  if (!find_closed(nodes, heat)) return 0.0;
  for (std::size_t k = 0; k < near_.size(); ++k) {
    const LostBond& bond = bonds_[static_cast<std::size_t>(near_[k])];
    const double s = stretches_[k];
    // Coinciding nodes must not divide by zero.
    if (approach_of(bond) == 0.0 || !(s > -1.0 && s < gone)) continue;
    const Vec2 force = force_of(bond, nodes, s);
    nodes[static_cast<std::size_t>(bond.one)].force.add(force);
    nodes[static_cast<std::size_t>(bond.other)].force.subtract(force);
    if (friction > 0.0) resist(bond, nodes, force, friction);
  }
  return stored();
}

// Across every lost bond. Along faces the parts of all bonds add up to the coefficient times the
// pressure, as those along the bonds do to the pressure; across the faces they cancel. `force` is
// that on the end that keeps the bond. A bond holds by its share of what the faces of its ends
// bear.
void CrackFaces::resist(const LostBond& bond, std::span<OpenNode> nodes, const Vec2& force,
                        double friction) const {
  constexpr double hold_of_face = 0.25;
  OpenNode& one = nodes[static_cast<std::size_t>(bond.one)];
  OpenNode& other = nodes[static_cast<std::size_t>(bond.other)];
  const double share =
      bond.stiffness / std::max(stiffness_[static_cast<std::size_t>(bond.one)].value().x(),
                                stiffness_[static_cast<std::size_t>(bond.other)].value().x());
  const double hold = hold_of_face * share * std::min(one.inertia, other.inertia);
  const Vec2 loss = loss_of({friction, 1.0}, -force, other.v - one.v, hold);
  other.loss.add(loss);
  one.loss.subtract(loss);
}

}  // namespace hackle
