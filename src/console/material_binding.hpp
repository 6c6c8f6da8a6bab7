// SPDX-License-Identifier: MIT
// material "duran50", material { E = 65*GPa, ... }
#pragma once

#include "console/object_type.hpp"
#include "scene/material.hpp"

namespace hackle {

template <>
inline constexpr const char* type_name<Material> = "hackle.material";

const TypeDoc& material_type();
std::span<const Function> material_functions();

}  // namespace hackle
