// SPDX-License-Identifier: MIT
// material "duran50", material { E = 65*GPa, ... }
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

const TypeDoc& material_type();
std::span<const Function> material_functions();

}  // namespace hackle
