// SPDX-License-Identifier: MIT
// What a scene asks for beyond bonds and constant loads, and what it costs.
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

// The kernel first, then what the scene has of damping, heat, varying loads, contact and impactors.
std::vector<Stage> stages(const Simulation& simulation);

// What is done inside the kernel, bond by bond: "no-fail zones", "2 materials", ... Its share of
// the time cannot be told apart.
std::vector<std::string> kernel_features(const Simulation& simulation);

// "kernel 95.2 % (no-fail zones), contact 4.8 %"
std::string describe_features(const Simulation& simulation);

}  // namespace hackle
