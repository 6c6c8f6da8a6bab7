// SPDX-License-Identifier: MIT
// Whether numerical choices can work on a plate.
#pragma once

#include <cstdint>

#include "base/error.hpp"
#include "lattice/numerics.hpp"
#include "scene/plate.hpp"

namespace hackle {

// Adds a problem for every numerical choice that cannot work on this plate, and for a lattice that
// would need more memory (see needs.hpp) than `memory` bytes. One problem does not hide another,
// unless the second cannot be decided without the first: no limit of the step without a family,
// constants that apply and a material.
void check(const Plate& plate, const Numerics& numerics, std::uint64_t memory, Problems& problems);

}  // namespace hackle
