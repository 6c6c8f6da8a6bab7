// SPDX-License-Identifier: MIT
// Loads and supports of a plate, or of a simulation between two runs.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> load_methods_of_plate();
// A new load replaces the old one at the same place.
std::span<const Function> load_methods_of_simulation();
// Amplitudes: ramp, pulse, step_at.
std::span<const Function> amplitude_functions();

}  // namespace hackle
