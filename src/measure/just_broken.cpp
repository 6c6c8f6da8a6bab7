// SPDX-License-Identifier: MIT
#include "measure/just_broken.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

namespace hackle {
namespace {

// A bond may be listed twice, by both blocks of columns that computed it.
std::vector<BrokenBond> each_once(std::vector<BrokenBond> bonds) {
  const auto key = [](const BrokenBond& bond) { return std::tuple(bond.at, bond.word, bond.bit); };
  std::ranges::sort(bonds, {}, key);
  const auto same = [&](const BrokenBond& one, const BrokenBond& other) {
    return key(one) == key(other);
  };
  bonds.erase(std::unique(bonds.begin(), bonds.end(), same), bonds.end());
  return bonds;
}

// The bonds of node (0, 0) by their bits.
std::vector<LostBond> bonds_by_bit(const Family& family) {
  std::vector<LostBond> all;
  family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int bit) {
    all.resize(std::max(all.size(), static_cast<std::size_t>(bit) + 1));
    all[static_cast<std::size_t>(bit)] = {0, 0, a, b, xi.norm(), weight};
  });
  return all;
}

}  // namespace

std::vector<LostBond> just_broken(const Simulation& simulation) {
  std::vector<LostBond> lost;
  if (simulation.broken_bonds().empty()) return lost;
  const std::vector<LostBond> by_bit = bonds_by_bit(simulation.lattice().family);
  const NodeLayout layout = simulation.lattice().grid.layout();
  for (const BrokenBond& bond : each_once(simulation.broken_bonds())) {
    const int bit = 32 * bond.word + std::countr_zero(bond.bit);
    LostBond one = by_bit[static_cast<std::size_t>(bit)];
    one.j = static_cast<int>(bond.at / layout.stride());
    one.i = static_cast<int>(bond.at - layout.at(0, one.j));
    lost.push_back(one);
  }
  return lost;
}

}  // namespace hackle
