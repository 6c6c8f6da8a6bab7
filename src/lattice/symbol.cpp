// SPDX-License-Identifier: MIT
#include "lattice/symbol.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace hackle {
namespace {

using std::numbers::pi;

struct Peak {
  Vec2 k{0, 0};
  double value = -1.0;
};

// The best of a square of 2 n + 1 by 2 n + 1 samples around `centre`.
Peak best_around(const Family& family, const Vec2& centre, double half_width, int n) {
  Peak best;
  for (int j = -n; j <= n; ++j)
    for (int i = -n; i <= n; ++i) {
      const Vec2 k = centre + Vec2(i, j) * (half_width / n);
      const double value = symbol(family, 1.0, 1.0, k).most;
      if (value > best.value) best = {k, value};
    }
  return best;
}

}  // namespace

Branches symbol(const Family& family, double c, double dx, const Vec2& k) {
  Eigen::Matrix2d D = Eigen::Matrix2d::Zero();
  family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int) {
    // 1 - cos x = 2 sin^2(x/2), no cancellation; twice, for the opposite bond.
    const double half_sine = std::sin(0.5 * k.dot(Vec2(a, b)));
    D += weight * 4.0 * half_sine * half_sine / (xi.squaredNorm() * xi.norm()) *
         (xi * xi.transpose());
  });
  D *= c * dx;  // V = dx^2, and xi xi^T/|xi|^3 is 1/dx
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(D, Eigen::EigenvaluesOnly);
  return {solver.eigenvalues()[0], solver.eigenvalues()[1]};
}

double largest_frequency(const Family& family, double c, double rho, double dx) {
  // A scan of the zone [0, pi]^2 with eight samples to the shortest oscillation 2 pi/reach, then
  // ever smaller squares around the best sample.
  const int samples = 2 * family.reach();
  Peak best = best_around(family, {0.5 * pi, 0.5 * pi}, 0.5 * pi, samples);
  double half_width = 0.5 * pi / samples;
  for (int halvings = 0; halvings < 24; ++halvings, half_width *= 0.5) {
    const Peak finer = best_around(family, best.k, half_width, 2);
    if (finer.value > best.value) best = finer;
  }
  return std::sqrt(c * dx * best.value / rho);
}

double step_limit(const Family& family, double c, double rho, double dx) {
  return 2.0 / largest_frequency(family, c, rho, dx);
}

}  // namespace hackle
