// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "solver/simulation.hpp"

namespace hackle {

// Returns all inputs of a run in SI units: every member of the plate and its loads, and the
// numerics, with the resulting constants and step. JSON text, UTF-8. A function of place or time is
// written as { "function": its text }.
std::string inputs_of(const Simulation& simulation);

// Returns the same before a simulation exists, with the numerics as requested.
std::string inputs_of(const Plate& plate, const Numerics& numerics);

}  // namespace hackle
