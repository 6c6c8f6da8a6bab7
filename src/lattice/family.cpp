// SPDX-License-Identifier: MIT
#include "lattice/family.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/cell_area.hpp"

namespace hackle {
namespace {

double whole_if_near(double m) {
  const double whole = std::round(m);
  return std::abs(m - whole) <= 1e-9 * whole ? whole : m;
}

// Weights up to this are rounding errors: a cell that only touches the horizon, or a bond as long
// as the range of a conical micromodulus.
constexpr double no_weight = 1e-12;

struct Weighted {
  Vec2 xi{0, 0};
  double weight = 0.0;
};

Weighted quadrature_of(int a, int b, double m, Quadrature quadrature) {
  const Vec2 node(a, b);
  const CellPart part = cell_inside_circle(a, b, m);
  switch (quadrature) {
    case Quadrature::full:
      return {node, static_cast<double>(a * a + b * b) <= m * m ? 1.0 : 0.0};
    case Quadrature::ramp:
      return {node, static_cast<double>(a * a + b * b) <= m * m
                        ? std::min(1.0, 0.5 + (m - node.norm()))
                        : 0.0};
    case Quadrature::area:
      return {node, part.area};
    case Quadrature::centroid:
      return {part.centroid, part.area};
  }
  return {};
}

double shape(double length, double m, Micromodulus micromodulus) {
  return micromodulus == Micromodulus::constant ? 1.0 : std::max(0.0, 1.0 - length / m);
}

}  // namespace

Family::Family(double m, Quadrature quadrature, Micromodulus micromodulus)
    : m_(whole_if_near(m)), quadrature_(quadrature), micromodulus_(micromodulus) {
  const int farthest = static_cast<int>(m_) + 1;
  for (int b = farthest; b >= 0; --b)
    for (int a = b == 0 ? 1 : 0; a <= farthest; ++a) {
      const Weighted bond = quadrature_of(a, b, m_, quadrature);
      const double weight = bond.weight * shape(bond.xi.norm(), m_, micromodulus);
      if (weight <= no_weight) continue;
      Images image{a, b, bond.xi, weight, bits_};
      if (image.is_quad() && image.first_bit % 32 == 31) ++image.first_bit;
      images_.push_back(image);
      kept_ += image.kept();
      bits_ = image.first_bit + image.kept();
      reach_ = std::max({reach_, a, b});
    }
}

}  // namespace hackle
