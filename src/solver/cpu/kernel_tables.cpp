// SPDX-License-Identifier: MIT
#include "solver/cpu/kernel_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hackle {
namespace {

// Coefficients of e^0, e^1, ... in the series of g(e)/e (series_terms in kernel.hpp).
template <class Real>
inline constexpr std::array<double, series_terms<Real>> g_over_e{};
template <>
inline constexpr std::array<double, 3> g_over_e<float>{0.5, -0.3750125174481315,
                                                       0.31251126571682525};
template <>
inline constexpr std::array<double, 6> g_over_e<double>{0.5,
                                                        -0.375,
                                                        0.3124999999725654,
                                                        -0.2734374999742801,
                                                        0.24609854452148686,
                                                        -0.22559043236480483};

template <class Real>
BondClass<Real> bond_class(const Images& image, double unit, double s0, bool varied) {
  const double L2 = image.xi.squaredNorm();
  const double pull = unit * image.weight / std::sqrt(L2);
  BondClass<Real> entry;
  entry.a = static_cast<Real>(image.xi.x());
  entry.b = static_cast<Real>(image.xi.y());
  double scale = pull;
  for (std::size_t term = 0; term < entry.series.size(); ++term) {
    scale /= L2;
    entry.series[term] = static_cast<Real>(scale * g_over_e<Real>[term]);
  }
  entry.range = static_cast<Real>(L2 * static_cast<double>(series_range<Real>));
  entry.most = static_cast<Real>(L2 * threshold_of(s0));
  entry.sure = varied ? entry.range : std::min(entry.range, entry.most);
  entry.L2 = static_cast<Real>(L2);
  entry.inverse_L2 = static_cast<Real>(1.0 / L2);
  entry.pull = static_cast<Real>(pull);
  entry.columns = image.a;
  entry.rows = image.b;
  entry.images = image.kept();
  entry.word = image.first_bit / 32;
  entry.bit = std::uint32_t{1} << (image.first_bit % 32);
  return entry;
}

}  // namespace

double threshold_of(double stretch) {
  return stretch * (2.0 + stretch);
}

template <class Real>
std::vector<BondClass<Real>> bond_classes(const Lattice& lattice, double dt, bool varied) {
  const double unit = lattice.calibration.c * lattice.grid.dx * dt * dt / lattice.rho;
  std::vector<BondClass<Real>> classes;
  for (const Images& image : lattice.family.images())
    classes.push_back(bond_class<Real>(image, unit, lattice.calibration.s0, varied));
  return classes;
}

template <class Real>
std::vector<NodeLoad<Real>> node_loads(const std::vector<LoadedNode>& forces, double unit) {
  std::vector<NodeLoad<Real>> loads;
  loads.reserve(forces.size());
  for (const LoadedNode& node : forces) {
    const Vec2 in_units = node.acceleration * unit;
    loads.push_back({node.i, static_cast<Real>(in_units.x()), static_cast<Real>(in_units.y())});
  }
  return loads;
}

template <class Real>
std::vector<PrescribedMotion<Real>> prescribed_motions(
    const std::vector<PrescribedNode>& prescribed) {
  std::vector<PrescribedMotion<Real>> motions;
  motions.reserve(prescribed.size());
  for (const PrescribedNode& node : prescribed)
    motions.push_back({node.i, node.along_x, node.along_y, static_cast<Real>(node.move.x()),
                       static_cast<Real>(node.move.y())});
  return motions;
}

template <class Real>
BoundFactors<Real> bound_factors(const Family& family) {
  BoundFactors<Real> factors;
  const auto raise = [](Real& factor, double to) {
    factor = std::max(factor, static_cast<Real>(1.000001 * to));
  };
  for (const Images& image : family.images()) {
    const Vec2 offset(image.a, image.b), xi = image.xi;
    const double L2 = xi.squaredNorm();
    if (xi == offset) continue;
    raise(factors.direct, xi.cwiseProduct(offset).lpNorm<1>() / L2);
    raise(factors.shear,
          std::max(std::abs(xi.x() * offset.y()), std::abs(xi.y() * offset.x())) / L2);
    raise(factors.squares, offset.squaredNorm() / L2);
  }
  return factors;
}

template <class Real>
LinearStencil<Real> linear_stencil(const std::vector<BondClass<Real>>& classes) {
  LinearStencil<Real> stencil;
  for (const BondClass<Real>& k : classes)
    stencil.reach = std::max({stencil.reach, k.columns, k.rows});
  stencil.round = true;
  for (const BondClass<Real>& k : classes) {
    const Real pull = k.pull * k.inverse_L2;
    stencil.weights[k.columns][k.rows] = {pull * k.a * k.a, pull * k.a * k.b, pull * k.b * k.b};
    stencil.max_rows[k.columns] = std::max(stencil.max_rows[k.columns], k.rows);
    const auto bonds = static_cast<Real>(2 * k.images);
    stencil.own_x += bonds * pull * k.a * k.a;
    stencil.own_y += bonds * pull * k.b * k.b;
    if (k.columns * k.columns + k.rows * k.rows > stencil.reach * stencil.reach)
      stencil.round = false;
  }
  return stencil;
}

template std::vector<BondClass<float>> bond_classes(const Lattice&, double, bool);
template std::vector<BondClass<double>> bond_classes(const Lattice&, double, bool);
template std::vector<NodeLoad<float>> node_loads(const std::vector<LoadedNode>&, double);
template std::vector<NodeLoad<double>> node_loads(const std::vector<LoadedNode>&, double);
template std::vector<PrescribedMotion<float>> prescribed_motions(
    const std::vector<PrescribedNode>&);
template std::vector<PrescribedMotion<double>> prescribed_motions(
    const std::vector<PrescribedNode>&);
template BoundFactors<float> bound_factors(const Family&);
template BoundFactors<double> bound_factors(const Family&);
template LinearStencil<float> linear_stencil(const std::vector<BondClass<float>>&);
template LinearStencil<double> linear_stencil(const std::vector<BondClass<double>>&);

}  // namespace hackle
