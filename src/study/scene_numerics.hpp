// SPDX-License-Identifier: MIT
// The numerics that a run had, and settings that change them.
#pragma once

#include <string>

#include "study/case.hpp"

namespace hackle {

// What the last simulation of a run used; lengths in m, times in s.
struct SceneNumerics {
  double spacing = 0.0;
  double horizon = 0.0;
  double dt = 0.0;
  double step_limit = 0.0;
  double duration = 0.0;  // simulated
  double nodes = 0.0;
  std::string precision, quadrature, micromodulus, constants, surface, breaking;
  double fidelity = 0.0;
  double safety = 0.0;
  bool fused = false;
  double alpha = 0.0;  // of the material
  double E = 0.0;      // of the material, Pa

  bool has_step = false;  // the script gives the time step itself

  double m() const { return horizon / spacing; }
  // Settings that take away a time step that the script gives: it suits no other lattice.
  Settings own_step() const;
};

// Throws Error (run_failed) if the run made no simulation.
SceneNumerics numerics_of(const Outcome& outcome);

// Settings of simulate.
Settings spaced(double spacing, double m);
// Returns the settings with a spacing and a horizon smaller by a factor, if they set them.
Settings with_finer_lattice(Settings settings, double factor);
Settings simulated(const std::string& key, const std::string& value);

// The smallest change of the stiffness that counts, relative: 2^-50 in f64, four units in the last
// place; 2^-22 in f32, two.
double last_bit(const SceneNumerics& scene);
// Changes Young's modulus by `number` of these: what that moves is not determined by the scene.
Settings last_bits(const SceneNumerics& scene, int number = 1);

}  // namespace hackle
