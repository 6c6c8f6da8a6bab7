// SPDX-License-Identifier: MIT
#include "solver/terms/cell_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {

Vec2 place_now(const Grid& grid, const State& state, int i, int j) {
  return grid.from_centre(i, j) + state.origin + state.u(i, j);
}

Vec2 way_to_cell(const Vec2& node, const Vec2& centre) {
  const auto shortened = [](double way) {
    return std::copysign(std::max(std::abs(way) - 0.5, 0.0), way);
  };
  const Vec2 way = node - centre;
  return {shortened(way.x()), shortened(way.y())};
}

Vec2 overlap_with_disc(const Vec2& node, const Vec2& centre, double radius) {
  const Vec2 way = way_to_cell(node, centre);
  const double r = way.norm();
  if (!(r < radius && r > 0.0)) return {0, 0};
  return ((radius - r) / r) * way;
}

Vec2 overlap_with_box(const Vec2& node, const Vec2& centre, const Vec2& half) {
  const Vec2 way = node - centre;
  const Vec2 deep = half + Vec2(0.5, 0.5) - way.cwiseAbs();
  if (!(deep.minCoeff() > 0.0)) return {0, 0};
  if (deep.y() <= deep.x()) return {0.0, std::copysign(deep.y(), way.y())};
  return {std::copysign(deep.x(), way.x()), 0.0};
}

double strength_of_push(const Plate& plate, const Lattice& lattice, double dt) {
  return plate.contact.value_or(Contact{}).stiffness * lattice.calibration.c * lattice.grid.dx *
         dt * dt / (lattice.rho * lattice.family.m());
}

}  // namespace hackle
