// SPDX-License-Identifier: MIT
// A linear elastic, ideally brittle material.
#pragma once

#include <string>

#include "base/described.hpp"
#include "base/error.hpp"

namespace hackle {

struct Material {
  std::string name;  // the user's name for it
  double E = 0.0;    // Young's modulus, Pa
  double rho = 0.0;  // density, kg/m3
  double nu = 0.0;   // Poisson's ratio of the real material, for comparison only: bond-based theory
                     // imposes its own (1/3 in plane stress)
  double G0 = 0.0;   // fracture energy, J/m2; 0 when s0 is given
  // Toughening by compression: a bond breaks at s0 - alpha s_min, where s_min is the smallest
  // stretch around its ends (paper Eq. 11).
  double alpha = 0.0;
  double alphaT = 0.0;  // thermal expansion, 1/K
  // Stress-optic fringe value, N/m per fringe: wavelength over stress-optic coefficient; 0 if
  // unknown.
  double fringe = 0.0;
  double s0 = 0.0;  // critical stretch, given instead of G0; 0: follows from G0
  double c = 0.0;   // N/m6, micromodulus, given to repeat another code's; 0: follows from E

  friend bool operator==(const Material&, const Material&) = default;
};

template <>
inline constexpr auto description_of<Material> = describe_noun(
    "material", "material",
    member("name", &Material::name, {.fallback = "own material", .sentence = "Name in reports."}),
    member("E", &Material::E,
           {.unit = "Pa", .range = above(0.0), .required = true, .sentence = "Young's modulus."}),
    member("rho", &Material::rho,
           {.unit = "kg/m3", .range = above(0.0), .required = true, .sentence = "Density."}),
    member("nu", &Material::nu,
           {.range = strictly_between(-1.0, 0.5),
            .fallback = "1/3",
            .sentence = "Poisson's ratio of the real material; the model's is 1/3, 1/4 in plane "
                        "strain."}),
    member("G0", &Material::G0,
           {.unit = "J/m2",
            .range = above(0.0),
            .alternative = true,
            .sentence = "Fracture energy of the model, 2 gamma; or give s0."}),
    member("s0", &Material::s0,
           {.range = strictly_between(0.0, 1.0),
            .alternative = true,
            .sentence = "Critical stretch instead of G0, which then follows from it."}),
    member("c", &Material::c,
           {.unit = "N/m6",
            .range = at_least(0.0),
            .fallback = "from E",
            .sentence = "Micromodulus, to repeat the deck of another code; the resulting modulus "
                        "is printed, and E serves only for estimates."}),
    member("alphaT", &Material::alphaT,
           {.unit = "1/K",
            .range = at_least(0.0),
            .fallback = "0",
            .sentence = "Thermal expansion.",
            .remedy = "glass has 3e-6 to 9e-6, steel 12e-6"}),
    member("fringe", &Material::fringe,
           {.unit = "N/m",
            .range = at_least(0.0),
            .fallback = "0, unknown",
            .sentence = "Stress-optic fringe value, for pictures of fringes.",
            .remedy = "glass has 140e3 to 210e3, Homalite-100 22e3"}),
    member("alpha", &Material::alpha,
           {.range = from_to_below(0.0, 1.0),
            .fallback = "0",
            .sentence = "Toughening by compression. The paper names two values: 0.25, which it "
                        "calls typical, and 0.02, which it uses; both after Silling & Askari."}));

// Adds a problem for every value outside its range.
void check(const Material& material, Problems& problems);

// Returns "Duran 50 (E 65 GPa, rho 2235 kg/m3, G0 204 J/m2)"; includes alpha and alphaT if above 0,
// and s0 instead of G0 if it is given.
std::string describe(const Material& material);

}  // namespace hackle
