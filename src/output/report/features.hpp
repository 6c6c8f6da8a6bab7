// SPDX-License-Identifier: MIT
// The features that a scene uses beyond bonds and constant loads, and their cost.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/simulation.hpp"

namespace hackle {

// A part of every step and its share of the time of all steps so far, 0 before the first.
struct Stage {
  std::string_view name;
  double share = 0.0;
};

// Returns the kernel, then the scene's damping, heat, varying loads, contact and impactors.
std::vector<Stage> stages(const Simulation& simulation);

// Returns the features inside the kernel, which work bond by bond: "no-fail zones", "2 materials",
// ... Their shares of the time cannot be separated.
std::vector<std::string> kernel_features(const Simulation& simulation);

// Returns "kernel 95.2 % (no-fail zones), contact 4.8 %".
std::string describe_features(const Simulation& simulation);

}  // namespace hackle
