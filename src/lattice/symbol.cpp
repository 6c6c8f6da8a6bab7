// SPDX-License-Identifier: MIT
#include "lattice/symbol.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>

namespace hackle {
namespace {

using std::numbers::pi;

// A square in the zone of wave vectors (all have the same size), with the symbol at its centre.
struct Cell {
  Vec2 centre{0, 0};
  double value = 0.0;
};

Cell cell_at(const Family& family, const Vec2& centre) {
  return {centre, symbol(family, 1.0, 1.0, centre).max};
}

// Returns the quarters of the cells, except those beyond the diagonal: exchanging x and y changes
// nothing.
std::vector<Cell> quarters(const Family& family, const std::vector<Cell>& cells, double half) {
  std::vector<Cell> list;
  for (const Cell& cell : cells)
    for (const double x : {-half, half})
      for (const double y : {-half, half}) {
        const Vec2 centre = cell.centre + Vec2(x, y);
        if (centre.y() <= centre.x()) list.push_back(cell_at(family, centre));
      }
  return list;
}

// Bounds the second derivatives of n.D(k)n, for c = dx = 1, over all k and unit vectors n: the
// largest T(n, n, d, d) of T = sum_p w_p xi xi o o/|xi|^3 over the directed bonds, o the offset. T
// has the symmetry of a square, so that with the angles of n and d it is
// (A + B)/2 + (A - B)/2 cos cos + S sin sin.
double curvature_bound(const Family& family) {
  double A = 0.0, B = 0.0, S = 0.0;
  family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int) {
    const double factor = 2.0 * weight / std::pow(xi.norm(), 3);
    A += factor * xi.x() * xi.x() * a * a;
    B += factor * xi.x() * xi.x() * b * b;
    S += factor * xi.x() * xi.y() * a * b;
  });
  return 0.5 * (A + B) + std::max(0.5 * std::abs(A - B), std::abs(S));
}

// Computes the maximum of the symbol for c = dx = 1, to a relative 1e-9. The gradient vanishes at
// the peak, so the value drops by at most curvature/2 times the square of the distance from it. A
// cell whose centre lies further below the best value found cannot contain the peak.
double peak(const Family& family) {
  const double curvature = curvature_bound(family);
  double half = 0.5 * pi, best = 0.0;
  std::vector<Cell> cells{cell_at(family, {half, half})};
  do {
    half *= 0.5;
    cells = quarters(family, cells, half);
    for (const Cell& cell : cells) best = std::max(best, cell.value);
    const double drop = curvature * half * half;  // the corner is sqrt(2) half away
    std::erase_if(cells, [&](const Cell& cell) { return cell.value + drop < best; });
  } while (curvature * half * half > 1e-9 * best);
  return best;
}

}  // namespace

Branches symbol(const Family& family, double c, double dx, const Vec2& k) {
  Eigen::Matrix2d D = Eigen::Matrix2d::Zero();
  family.for_each_bond([&](int a, int b, const Vec2& xi, double weight, int) {
    // 1 - cos x = 2 sin^2(x/2) avoids cancellation; doubled for the opposite bond.
    const double half_sine = std::sin(0.5 * k.dot(Vec2(a, b)));
    D += weight * 4.0 * half_sine * half_sine / (xi.squaredNorm() * xi.norm()) *
         (xi * xi.transpose());
  });
  D *= c * dx;  // V = dx^2, and xi xi^T/|xi|^3 has the unit 1/dx
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(D, Eigen::EigenvaluesOnly);
  return {solver.eigenvalues()[0], solver.eigenvalues()[1]};
}

double largest_frequency(const Family& family, double c, double rho, double dx) {
  return std::sqrt(c * dx * peak(family) / rho);
}

double step_limit(const Family& family, double c, double rho, double dx, const Touching& touching) {
  const double bonds = largest_frequency(family, touching.bonds * c, rho, dx);
  const double others =
      std::sqrt(touching.nodes * c * dx / (family.m() * rho) + touching.springs / rho);
  const double omega = std::hypot(bonds, others) / touching.left_by_drag;
  const double zeta = 0.5 * touching.stiffness_damping * bonds * bonds / omega;
  return 2.0 / omega / (std::hypot(1.0, zeta) + zeta);  // without a difference of large numbers
}

}  // namespace hackle
