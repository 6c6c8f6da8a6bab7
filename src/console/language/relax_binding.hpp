// SPDX-License-Identifier: MIT
// Static equilibrium of a simulation: s:relax and s:quasistatic.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> relax_methods();

}  // namespace hackle
