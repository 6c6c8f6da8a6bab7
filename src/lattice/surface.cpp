// SPDX-License-Identifier: MIT
#include "lattice/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "lattice/carve.hpp"

namespace hackle {
namespace {

// Directions k pi/8; the mirror image of direction k is direction -k.
constexpr int directions = 8;
using Energies = std::array<double, directions>;  // of a bond or a node, by the direction of strain

// The energies of a bond of each class: the first image of a quad, or a pair.
using Table = std::vector<Energies>;

// Returns w (xi.n)^2 (o.n)^2/|xi|^3, the energy of a bond when the lattice is strained along n,
// in units that all bonds share.
double strain_energy(const Images& image, double angle) {
  const Vec2 n(std::cos(angle), std::sin(angle)), offset(image.a, image.b);
  const double along = image.xi.dot(n) * offset.dot(n);
  return image.weight * along * along / (image.xi.squaredNorm() * image.length());
}

Table table_of(Surface surface, const Family& family) {
  Table table;
  for (const Images& image : family.images()) {
    Energies& own = table.emplace_back();
    for (std::size_t k = 0; k < own.size(); ++k)
      own[k] = surface == Surface::energy
                   ? strain_energy(image, static_cast<double>(k) * std::numbers::pi / directions)
                   : image.weight;
  }
  return table;
}

// How many of the two bonds along (a, b), and of the two along (-a, b), a node has.
struct Count {
  int rising = 0, falling = 0;
};

// Adds the bonds of one class. Mirror images exchange the two counts and the directions k and -k,
// so their sums are alike to the last bit.
void add(const Count& count, const Energies& bond, Energies& sum) {
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] += count.rising * bond[k] + count.falling * bond[(directions - k) % directions];
}

Energies whole(const Family& family, const Table& table) {
  Energies sum{};
  for (std::size_t k = 0; k < table.size(); ++k)
    add({2, family.images()[k].is_quad() ? 2 : 0}, table[k], sum);
  return sum;
}

// Reads the bonds of a node at either end.
class Ends {
 public:
  Ends(const Grid& grid, const BondBits& bonds) : grid_(grid), bonds_(bonds) {}

  Count count(int i, int j, const Images& image) const {
    const int a = image.a, b = image.b, bit = image.first_bit;
    const int rising = holds(i, j, bit) + holds(i - a, j - b, bit);
    if (!image.is_quad()) return {rising, 0};
    return {rising, holds(i, j, bit + 1) + holds(i + a, j - b, bit + 1)};
  }

 private:
  int holds(int i, int j, int bit) const {
    return grid_.contains(i, j) && bonds_.holds(grid_.layout().at(i, j), bit) ? 1 : 0;
  }

  const Grid& grid_;
  const BondBits& bonds_;
};

// The reciprocal of the largest share of its energy that a node has kept, over all directions: a
// surface has no stress across it, so what counts is the strain along it.
double factor_of(const Energies& node, const Energies& all) {
  double share = 0.0;
  for (std::size_t k = 0; k < all.size(); ++k) share = std::max(share, node[k] / all[k]);
  return 1.0 / std::clamp(share, 1.0 / most_surface_factor, 1.0);
}

}  // namespace

double stiffening(Surface surface) {
  return surface == Surface::none ? 1.0 : most_surface_factor;
}

std::vector<float> surface_factors(Surface surface, const Grid& grid, const Family& family,
                                   const BondBits& bonds) {
  if (surface == Surface::none) return {};
  const Table table = table_of(surface, family);
  const Energies all = whole(family, table);
  const Ends ends(grid, bonds);
  std::vector<float> factors(grid.nodes());
  for_nodes(grid, [&](int i, int j) {
    Energies own{};
    for (std::size_t k = 0; k < table.size(); ++k)
      add(ends.count(i, j, family.images()[k]), table[k], own);
    factors[grid.index(i, j)] = static_cast<float>(factor_of(own, all));
  });
  return factors;
}

}  // namespace hackle
