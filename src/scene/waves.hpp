// SPDX-License-Identifier: MIT
// Speeds of elastic waves in a plate.
#pragma once

#include "scene/plate.hpp"

namespace hackle {

// All speeds in m/s.
struct WaveSpeeds {
  double longitudinal = 0.0;  // c_L = sqrt(E / (rho (1 - nu^2))) in plane stress,
                              // sqrt(E (1 - nu) / (rho (1 + nu) (1 - 2 nu))) in plane strain
  double shear = 0.0;         // c_S = sqrt(E / (2 rho (1 + nu)))
  double rayleigh = 0.0;      // c_R, smallest root of (2 - v^2/c_S^2)^2 =
                              // 4 sqrt(1 - v^2/c_S^2) sqrt(1 - v^2/c_L^2)
                              // (src/lattice/README.md 4.6)
};

// E in Pa, rho in kg/m3, nu in (-1, 0.5).
WaveSpeeds wave_speeds(double E, double nu, double rho, Plane plane = Plane::stress);

}  // namespace hackle
