// SPDX-License-Identifier: MIT
// A linear elastic, ideally brittle material.
#pragma once

#include <string>

#include "base/error.hpp"

namespace hackle {

struct Material {
  std::string name;  // as the user calls it
  double E = 0.0;    // Young's modulus, Pa, > 0
  double rho = 0.0;  // density, kg/m3, > 0
  double nu = 0.0;  // Poisson's ratio of the real material, in (-1, 0.5); bond-based theory imposes
                    // its own (1/3 in plane stress), this one is for comparison only
  double G0 = 0.0;  // fracture energy, J/m2, > 0; 0 when s0 is given
  // How far compression toughens it: a bond breaks at s0 - alpha s_min, where s_min is the least
  // stretch around its ends (paper Eq. 11); in [0, 1).
  double alpha = 0.0;
  double alphaT = 0.0;  // thermal expansion, 1/K, >= 0
  // Stress-optic fringe value, N/m for each fringe: wavelength over stress-optic coefficient; 0
  // where it is not known.
  double fringe = 0.0;
  double s0 = 0.0;  // critical stretch in (0, 1), given instead of G0; 0: it follows from G0

  friend bool operator==(const Material&, const Material&) = default;
};

// Adds a problem for every value outside its range.
void check(const Material& material, Problems& problems);

// "Duran 50 (E 65 GPa, rho 2235 kg/m3, G0 204 J/m2)"; alpha and alphaT above 0 are said
// too, and s0 instead of G0 where it is given.
std::string describe(const Material& material);

}  // namespace hackle
