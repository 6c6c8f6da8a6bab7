// SPDX-License-Identifier: MIT
// Loads and supports: on a plate before it is solved, on a simulation between two runs.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> load_methods_of_plate();
// They replace the like load at the same place.
std::span<const Function> load_methods_of_simulation();
// Amplitudes in time: ramp, pulse, step_at.
std::span<const Function> amplitude_functions();

}  // namespace hackle
