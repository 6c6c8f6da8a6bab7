// SPDX-License-Identifier: MIT
#include "study/scene_numerics.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"

namespace hackle {

SceneNumerics numerics_of(const Outcome& outcome) {
  const auto& told = outcome.told;
  if (!told.contains("numerics"))
    throw Error(ErrorKind::run_failed, "the script makes no simulation",
                "a study needs one that is run");
  const auto& numerics = told["numerics"];
  SceneNumerics scene;
  scene.spacing = numerics["spacing_m"].get<double>();
  scene.horizon = numerics["horizon_m"].get<double>();
  if (scene.horizon == 0.0) scene.horizon = 4.0 * scene.spacing;
  scene.dt = told["dt_s"].get<double>();
  scene.step_limit = told["dt_limit_s"].get<double>();
  scene.duration = told["time_s"].get<double>();
  scene.nodes = told["nodes"].get<double>();
  scene.precision = numerics["precision"].get<std::string>();
  scene.quadrature = numerics["quadrature"].get<std::string>();
  scene.micromodulus = numerics["micromodulus"].get<std::string>();
  scene.constants = numerics["constants"].get<std::string>();
  scene.breaking = numerics["breaking"].get<std::string>();
  scene.surface = numerics["surface"].get<std::string>();
  scene.fidelity = numerics["fidelity"].get<double>();
  scene.safety = numerics["safety"].get<double>();
  scene.fused = numerics["fused"].get<bool>();
  scene.has_step = numerics["step_s"].is_number();
  scene.alpha = told["material"]["alpha"].get<double>();
  scene.E = told["material"]["E_Pa"].get<double>();
  return scene;
}

Settings SceneNumerics::own_step() const {
  return has_step ? simulated("step", "default") : Settings();
}

// A horizon of exactly m spacings, whatever the rounding.
Settings spaced(double spacing, double m) {
  return {{"simulate.spacing", shortest(spacing)}, {"simulate.horizon", shortest(spacing * m)}};
}

Settings with_finer_lattice(Settings settings, double factor) {
  for (const char* key : {"simulate.spacing", "simulate.horizon"})
    if (const auto at = settings.find(key); at != settings.end())
      at->second = shortest(std::stod(at->second) / factor);
  return settings;
}

Settings simulated(const std::string& key, const std::string& value) {
  return {{"simulate." + key, value}};
}

double last_bit(const SceneNumerics& scene) {
  return std::ldexp(1.0, scene.precision == "f64" ? -50 : -22);
}

Settings last_bits(const SceneNumerics& scene, int number) {
  return {{"material.E", shortest(scene.E * (1.0 + number * last_bit(scene)))}};
}

}  // namespace hackle
