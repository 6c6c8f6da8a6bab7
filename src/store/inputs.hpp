// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "solver/simulation.hpp"

namespace hackle {

// Everything that a run was made from, in SI units: every member of the plate and its loads, and
// the numerics, with the constants and the step that followed from them. JSON text, UTF-8. A
// function of place or time stands as { "function": what it is }.
std::string inputs_of(const Simulation& simulation);

// The same before anything has followed: numerics as they were asked for.
std::string inputs_of(const Plate& plate, const Numerics& numerics);

}  // namespace hackle
