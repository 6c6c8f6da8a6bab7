// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "solver/simulation.hpp"

namespace hackle {

// Everything that a run was made from, resolved, in SI units: plate, material, cracks, tractions,
// zones, numerics, and the constants and the step that followed from them. JSON text, UTF-8.
std::string inputs_of(const Simulation& simulation);

}  // namespace hackle
