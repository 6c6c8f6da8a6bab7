// SPDX-License-Identifier: MIT
// What is cut out of a plate, or is of another material: methods of a plate.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> shape_methods();

}  // namespace hackle
