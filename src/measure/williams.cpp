// SPDX-License-Identifier: MIT
#include "measure/williams.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/QR>

namespace hackle {
namespace {

constexpr int first_term = -1, last_term = 6;
constexpr int terms = last_term - first_term + 1;
constexpr int unknowns = 2 * terms + 1;  // term 0 is a translation along each axis; a rotation is
                                         // term 2 of sliding
constexpr double root_of_two_pi = 2.5066282746310002;

// The function of the angle of a term, and its derivative by the angle.
struct Angular {
  Vec2 value{0, 0}, slope{0, 0};
};

Angular angular(int n, FractureMode mode, double angle, double kappa) {
  const double p = 0.5 * n, q = p - 2.0, sign = n % 2 == 0 ? 1.0 : -1.0;
  const double cp = std::cos(p * angle), sp = std::sin(p * angle);
  const double cq = std::cos(q * angle), sq = std::sin(q * angle);
  if (mode == FractureMode::opening) {
    const double a = kappa + p + sign, b = kappa - p - sign;
    return {{a * cp - p * cq, b * sp + p * sq},
            {-p * a * sp + p * q * sq, p * b * cp + p * q * cq}};
  }
  const double a = kappa + p - sign, b = kappa - p + sign;
  return {{-a * sp + p * sq, b * cp + p * cq},
          {-p * a * cp + p * q * cq, -p * b * sp - p * q * sq}};
}

struct Fitted {
  Vec2 place{0, 0};  // in the frame, over the outer radius
  Vec2 u{0, 0};      // m, in the frame
};

// Nodes that no bond holds, or that lie on the line of the crack itself, belong to neither side.
std::vector<Fitted> fitted_nodes(const View& view, const TipFrame& frame, double inner,
                                 double outer) {
  const Grid& grid = view.lattice().grid;
  const auto intact = degrees(grid, view.lattice().family, view.state().bonds);
  std::vector<Fitted> nodes;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 place = frame.local(grid.position(i, j));
      const double r = place.norm();
      if (r < inner || r > outer || intact[grid.index(i, j)] == 0) continue;
      if (place.x() < 0.0 && std::abs(place.y()) < 0.25 * grid.dx) continue;
      nodes.push_back({place / outer, frame.turned(view.displacement(i, j))});
    }
  return nodes;
}

// Writes the two rows of a node: factors of the unknowns in its displacement along and across.
void write_rows(const Fitted& node, double kappa, Eigen::MatrixXd& matrix, Eigen::Index row) {
  Eigen::Index column = 0;
  for (int n = first_term; n <= last_term; ++n)
    for (const FractureMode mode : {FractureMode::opening, FractureMode::sliding}) {
      if (n == 0 && mode == FractureMode::sliding) continue;
      const Vec2 value = n == 0 ? Vec2(1, 0) : williams_term(n, mode, node.place, kappa).u;
      matrix.block<2, 1>(row, column++) = value;
    }
  matrix.block<2, 1>(row, column) = Vec2(0, 1);
}

}  // namespace

PlaneModuli plane_moduli(const Moduli& lattice) {
  const double bulk = 0.5 * (lattice.C11 + lattice.C12);
  const double shear = 0.25 * (lattice.C11 - lattice.C12) * (1.0 + lattice.zener);
  return {shear, 1.0 + 2.0 * shear / bulk};
}

TipField williams_term(int n, FractureMode mode, const Vec2& place, double kappa) {
  const double r = place.norm(), angle = std::atan2(place.y(), place.x()), p = 0.5 * n;
  const Angular of = angular(n, mode, angle, kappa);
  const double power = std::pow(r, p - 1.0);
  return {r * power * of.value,
          power * (p * std::cos(angle) * of.value - std::sin(angle) * of.slope)};
}

TipField unit_field(FractureMode mode, const Vec2& place, const PlaneModuli& moduli) {
  const double sign = mode == FractureMode::opening ? 1.0 : -1.0;
  const double unit = sign / (2.0 * moduli.shear * root_of_two_pi);
  const TipField term = williams_term(1, mode, place, moduli.kappa);
  return {unit * term.u, unit * term.ahead};
}

std::optional<WilliamsFit> fit_williams(const View& view, const TipFrame& frame, double inner,
                                        double outer, const PlaneModuli& moduli) {
  const std::vector<Fitted> nodes = fitted_nodes(view, frame, inner, outer);
  const auto rows = static_cast<Eigen::Index>(2 * nodes.size());
  constexpr Eigen::Index fewest = 3 * (Eigen::Index{unknowns} + 1);
  if (rows < fewest) return std::nullopt;
  Eigen::MatrixXd matrix(rows, unknowns);
  Eigen::VectorXd u(rows);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(2 * k);
    write_rows(nodes[k], moduli.kappa, matrix, row);
    u.segment<2>(row) = nodes[k].u;
  }
  const Eigen::VectorXd factors = matrix.colPivHouseholderQr().solve(u);
  const double scale = 2.0 * moduli.shear;             // of the terms, which are without it
  const auto factor = [&](int n, FractureMode mode) {  // of r in units of the outer radius
    const int before = n > 0 ? 1 : 0;
    const int column = 2 * (n - first_term) + (mode == FractureMode::sliding ? 1 : 0) - before;
    return scale * factors[column] * std::pow(outer, -0.5 * n);
  };
  const double left = (matrix * factors - u).norm(), all = u.norm();
  return WilliamsFit{root_of_two_pi * factor(1, FractureMode::opening),
                     -root_of_two_pi * factor(1, FractureMode::sliding),
                     4.0 * factor(2, FractureMode::opening), all > 0.0 ? left / all : 0.0};
}

}  // namespace hackle
