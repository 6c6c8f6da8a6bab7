// SPDX-License-Identifier: MIT
// simulate(p, { ... }) and the methods of a simulation.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

const TypeDoc& simulation_type();
std::span<const Function> simulation_functions();

}  // namespace hackle
