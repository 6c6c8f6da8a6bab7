// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "solver/simulation.hpp"

namespace hackle {

// Everything that a run was made from, resolved, in SI units: plate, material, cracks, tractions,
// zones, numerics, and the constants and the step that followed from them.
nlohmann::ordered_json inputs_of(const Simulation& simulation);

}  // namespace hackle
