// SPDX-License-Identifier: MIT
// Cut-outs, inclusions and cracks: methods of a plate.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> shape_methods();

}  // namespace hackle
