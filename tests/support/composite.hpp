// SPDX-License-Identifier: MIT
// Plates of several materials, and heated plates.
#pragma once

#include "support/scenes.hpp"

namespace hackle::test {

// The features of a plate beyond one cold material.
struct Mixture {
  bool mixed = false;
  bool heated = false;
  double alpha = 0.0;  // of the plate; inclusions have twice this value
};

// Softer, lighter and weaker than glass, with a larger thermal expansion.
inline Material resin() {
  Material material{"resin", 3.5e9, 1200.0, 0.3, 150.0};
  material.alphaT = 60e-6;
  return material;
}

inline Material steel() {
  Material material{"steel", 210e9, 7850.0, 0.3, 20e3};
  material.alphaT = 12e-6;
  return material;
}

inline Shape disc(const Vec2& centre, double radius) {
  return Ellipse{centre, {radius, radius}, 0.0};
}

// Makes a glass plate with a disc of resin, a bar of steel and a hole, none of which touch; its
// upper half is heated by a field, and the whole plate by a ramp of some microseconds.
inline Plate composite(int nx, int ny, const Mixture& mixture) {
  Plate plate = bare_plate(nx, ny);
  const double w = plate.width, h = plate.height;
  plate.material.alpha = mixture.alpha;
  plate.material.alphaT = 4e-6;
  if (mixture.mixed) {
    Material soft = resin(), stiff = steel();
    soft.alpha = stiff.alpha = 2.0 * mixture.alpha;
    plate.inclusions.push_back({disc({0.3 * w, 0.6 * h}, 0.18 * h), soft});
    plate.inclusions.push_back({rectangle({0.6 * w, 0.1 * h}, {0.7 * w, 0.8 * h}), stiff});
    plate.cutouts.push_back({disc({0.85 * w, 0.5 * h}, 0.1 * h), "bore"});
  }
  if (mixture.heated) {
    plate.loads.thermal_loads.push_back(
        {rectangle({0.0, 0.5 * h}, {w, h}),
         ScalarField([w](const Vec2& x) { return 150.0 * x.x() / w - 50.0; }), Amplitude()});
    plate.loads.thermal_loads.push_back({std::nullopt, 80.0, ramp(2e-6)});
  }
  return plate;
}

}  // namespace hackle::test
