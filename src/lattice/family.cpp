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

int Images::column(int k) const {
  if (is_quad()) return k < 2 ? a : -a;
  return k == 0 ? a : -a;
}

int Images::row(int k) const {
  if (is_quad()) return k % 2 == 0 ? b : -b;
  return k == 0 ? b : -b;
}

double Images::length() const {
  return std::sqrt(static_cast<double>(a * a + b * b));
}

Family::Family(double m, Quadrature quadrature)
    : m_(whole_if_near(m)), quadrature_(quadrature), reach_(static_cast<int>(m_)) {
  const auto add = [&](int a, int b) {
    if (static_cast<double>(a * a + b * b) > m_ * m_) return;
    Images image{a, b, 0.0, bonds_};
    image.weight = weight_of(image.length(), m_, quadrature_);
    images_.push_back(image);
    bonds_ += image.count();
  };
  for (int b = 1; b <= reach_; ++b)
    for (int a = 1; a <= reach_; ++a) add(a, b);
  for (int a = 1; a <= reach_; ++a) add(a, 0);
  for (int b = 1; b <= reach_; ++b) add(0, b);
}

}  // namespace hackle
