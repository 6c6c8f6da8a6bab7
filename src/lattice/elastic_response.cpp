// SPDX-License-Identifier: MIT
#include "lattice/elastic_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lattice/symbol.hpp"

namespace hackle {
namespace {

// Of the bonds that node (i, j) keeps: c w |xi| times the mean of s^2 under a strain of 1 along x
// and along y, |xi| in dx. The offset strains, also where the quadrature moves xi.
double share_of_node(const Lattice& lattice, int i, int j) {
  const auto at = lattice.grid.layout().at(i, j);
  const double c = lattice.micromodulus_at(i, j);
  double sum = 0.0;
  lattice.family.for_each_bond([&](int column, int row, const Vec2& xi, double weight, int bit) {
    if (!lattice.bonds.holds(at, bit)) return;
    const double of_bond = 0.5 * (c + lattice.micromodulus_at(i + column, j + row));
    const Vec2 stretch = Vec2(xi.x() * column, xi.y() * row) / xi.squaredNorm();
    sum += of_bond * weight * xi.norm() * 0.5 * stretch.squaredNorm();
  });
  return sum;
}

double stiffness_of(const Lattice& lattice) {
  double sum = 0.0;
  std::int64_t nodes = 0;
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i)
      if (!lattice.is_void(i, j)) {
        ++nodes;
        sum += share_of_node(lattice, i, j);
      }
  // V^2 |xi| over the area dx^2 of a node.
  return nodes == 0 ? 0.0 : sum * std::pow(lattice.grid.dx, 3) / static_cast<double>(nodes);
}

// m/s; `k` in rad/m.
double phase_velocity(const Lattice& lattice, double k, double dt) {
  const double dx = lattice.grid.dx;
  const Branches branches = symbol(lattice.family, lattice.calibration.c, dx, Vec2(k * dx, 0.0));
  const double omega = std::sqrt(branches.max / lattice.rho);
  return 2.0 / dt * std::asin(std::min(1.0, 0.5 * omega * dt)) / k;
}

}  // namespace

ElasticResponse elastic_response(const Lattice& lattice, double dt) {
  constexpr double waves_across = 5.0;
  const Grid& grid = lattice.grid;
  ElasticResponse response{.stiffness = stiffness_of(lattice)};
  response.wavelength = grid.dx * std::max(2.0, std::min(grid.nx, grid.ny) / waves_across);
  response.wave_speed = phase_velocity(lattice, 2.0 * std::numbers::pi / response.wavelength, dt);
  return response;
}

}  // namespace hackle
