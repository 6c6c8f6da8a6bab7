// SPDX-License-Identifier: MIT
// Queries about the state of a simulation: s:cracks, s:at.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> measure_methods();

}  // namespace hackle
