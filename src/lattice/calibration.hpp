// SPDX-License-Identifier: MIT
// Micromodulus and critical stretch of a family, and the elastic moduli and fracture energy that
// result on the lattice. Per metre of thickness.
#pragma once

#include "lattice/family.hpp"
#include "scene/material.hpp"

namespace hackle {

// Moduli of the square lattice for a small uniform strain (src/lattice/README.md 3.1):
// C11 = 1/2 c V sum w x^4/r^3 and C12 = 1/2 c V sum w x^2 y^2/r^3 over the directed bonds; with
// centroids one x (and one y) of each square is that of the node.
struct Moduli {
  double C11 = 0.0;    // Pa
  double C12 = 0.0;    // Pa; equals C66, except with centroids
  double E = 0.0;      // Young's modulus along a lattice axis, Pa
  double nu = 0.0;     // Poisson's ratio along a lattice axis: near 1/3 in plane stress, 1/4 in
                       // plane strain
  double zener = 0.0;  // 2 C66/(C11 - C12); 1 means isotropic
};

struct Calibration {
  double c = 0.0;   // micromodulus (at r = 0), N/m6 for a plate of 1 m thickness
  double s0 = 0.0;  // critical stretch
  Moduli moduli;
  double G0 = 0.0;  // fracture energy of a straight cut along a lattice axis, J/m2
};

// Computes the moduli. In plane strain E and nu are those of the solid with these C11 and C12.
Moduli moduli(const Family& family, double c, double dx, Plane plane = Plane::stress);

// Computes the energy per area to break all bonds across a straight cut with unit normal `normal`:
// G = 1/4 sum_p w_p c s0^2 |xi_p| |o_p . n| V over the directed bonds, where o_p is the offset of
// the neighbour (src/lattice/README.md 3.4). J/m2.
double fracture_energy(const Family& family, double c, double s0, double dx, const Vec2& normal);

// Computes the constants of a material. If the material gives s0, it is used unchanged and G0
// follows from it. Constants::paper requires plane stress and the constant micromodulus.
Calibration calibrate(const Family& family, const Material& material, double dx,
                      Constants constants, Plane plane = Plane::stress);

}  // namespace hackle
