// SPDX-License-Identifier: MIT
#include "measure/node_value.hpp"

#include <cmath>

#include <Eigen/LU>

#include "measure/bond_field.hpp"
#include "measure/field.hpp"
#include "solver/bond_visit.hpp"

namespace hackle {
namespace {

template <int axis>
double displacement_along(const View& view, int i, int j) {
  return view.displacement(i, j)[axis];
}

template <int axis>
double velocity_along(const View& view, int i, int j) {
  return view.velocity(i, j)[axis];
}

template <double Stress::*part>
double stress_component(const View& view, int i, int j) {
  return bonds_of_node(view, i, j).stress.*part;
}

template <double (Stress::*part)() const>
double stress_measure(const View& view, int i, int j) {
  return (bonds_of_node(view, i, j).stress.*part)();
}

template <double Strain::*part>
double strain_part(const View& view, int i, int j) {
  return strain_of(view, i, j).*part;
}

constexpr auto list = std::to_array<NodeQuantity>({
    {"ux", "m", "Displacement along x.", displacement_along<0>},
    {"uy", "m", "Displacement along y.", displacement_along<1>},
    {"vx", "m/s", "Velocity along x.", velocity_along<0>},
    {"vy", "m/s", "Velocity along y.", velocity_along<1>},
    {"stress_xx", "Pa", "Stress along x.", stress_component<&Stress::xx>},
    {"stress_yy", "Pa", "Stress along y.", stress_component<&Stress::yy>},
    {"stress_xy", "Pa", "Shear stress.", stress_component<&Stress::xy>},
    {"stress_1", "Pa", "Larger principal stress.", stress_measure<&Stress::first>},
    {"stress_2", "Pa", "Smaller principal stress.", stress_measure<&Stress::second>},
    {"von_mises", "Pa", "Equivalent stress.", stress_measure<&Stress::von_mises>},
    {"strain_xx", "", "Strain along x.", strain_part<&Strain::xx>},
    {"strain_yy", "", "Strain along y.", strain_part<&Strain::yy>},
    {"strain_xy", "", "Shear strain, half the engineering one.", strain_part<&Strain::xy>},
    {"energy_density", "J/m3", "Strain energy for each volume.",
     [](const View& view, int i, int j) { return bonds_of_node(view, i, j).energy; }},
    {"stretch", "", "Largest stretch of its bonds over the critical one.",
     [](const View& view, int i, int j) { return bonds_of_node(view, i, j).closeness; }},
    {"damage", "", "Share of broken bonds.", damage_of},
    {"temperature", "K", "Change of temperature.", temperature_of},
});

}  // namespace

std::span<const NodeQuantity> node_quantities() {
  return list;
}

Strain strain_of(const View& view, int i, int j) {
  Eigen::Matrix2d shape = Eigen::Matrix2d::Zero(), moved = Eigen::Matrix2d::Zero();
  visit_bonds_of(i, j, view.lattice(), view.state(), view.thermal_strain(),
                 [&](const VisitedBond& bond) {
                   if (!bond.holds) return;
                   shape += bond.xi * bond.xi.transpose();
                   moved += bond.h * bond.xi.transpose();
                 });
  const double trace = shape.trace();
  constexpr double in_line = 1e-9;
  if (!(shape.determinant() > in_line * trace * trace)) return {};
  const Eigen::Matrix2d gradient = moved * shape.inverse();
  return {gradient(0, 0), gradient(1, 1), 0.5 * (gradient(0, 1) + gradient(1, 0))};
}

}  // namespace hackle
