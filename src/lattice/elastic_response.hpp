// SPDX-License-Identifier: MIT
// How stiff a plate is on its lattice, and how fast waves run on it: what the choice of a lattice
// and a step changes before anything breaks. No run is needed for it.
#pragma once

#include "lattice/lattice.hpp"

namespace hackle {

struct ElasticResponse {
  // Pa: twice the energy of the bonds that hold at t = 0 per area of the plate, under a uniform
  // strain along x or along y, over the square of the strain; the mean of both directions. Soft
  // rims and cracks count. C11 = E/(1 - nu^2) in a plate without rims.
  double stiffness = 0.0;
  // m: a fifth of the shorter side of the lattice, at least two spacings.
  double wavelength = 0.0;
  // m/s: the phase velocity of longitudinal waves of that length along x, in the plate's own
  // material. sqrt(C11/rho) on a fine lattice with a short step.
  double wave_speed = 0.0;
};

// Computes both for steps of `dt`, s. Source: the symbol of the lattice (src/lattice/README.md 4.1)
// and the dispersion of velocity Verlet, sin(omega' dt/2) = omega dt/2.
ElasticResponse elastic_response(const Lattice& lattice, double dt);

}  // namespace hackle
