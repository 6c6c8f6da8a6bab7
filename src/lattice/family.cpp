// SPDX-License-Identifier: MIT
#include "lattice/family.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

double whole_if_near(double m) {
  const double whole = std::round(m);
  return std::abs(m - whole) <= 1e-9 * whole ? whole : m;
}

double weight_of(double length, double m, Quadrature quadrature) {
  if (quadrature == Quadrature::full) return 1.0;
  return std::min(1.0, 0.5 + (m - length));
}

}  // namespace

Family::Family(double m, Quadrature quadrature)
    : m_(whole_if_near(m)), quadrature_(quadrature), reach_(static_cast<int>(m_)) {
  for (int b = reach_; b >= 0; --b)
    for (int a = b == 0 ? 1 : 0; a <= reach_; ++a) {
      if (static_cast<double>(a * a + b * b) > m_ * m_) continue;
      Images image{a, b, Vec2(a, b), 0.0, bits_};
      image.weight = weight_of(image.length(), m_, quadrature_);
      if (image.is_quad() && image.first_bit % 32 == 31) ++image.first_bit;
      images_.push_back(image);
      kept_ += image.kept();
      bits_ = image.first_bit + image.kept();
    }
}

}  // namespace hackle
