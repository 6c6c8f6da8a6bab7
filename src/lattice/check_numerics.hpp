// SPDX-License-Identifier: MIT
// Checks whether numerical choices can work on a plate.
#pragma once

#include <cstdint>

#include "base/error.hpp"
#include "lattice/numerics.hpp"
#include "scene/plate.hpp"

namespace hackle {

// Adds a problem for every numerical choice that cannot work on this plate, and for a lattice that
// would need more than `memory` bytes (see needs.hpp). Independent problems are all reported; a
// check that depends on a failed one is skipped: the step limit needs a family, applicable
// constants and a material.
void check(const Plate& plate, const Numerics& numerics, std::uint64_t memory, Problems& problems);

}  // namespace hackle
