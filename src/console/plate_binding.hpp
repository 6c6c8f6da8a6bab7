// SPDX-License-Identifier: MIT
// plate { ... } and what can be put on it.
#pragma once

#include "console/object_type.hpp"
#include "scene/plate.hpp"

namespace hackle {

template <>
inline constexpr const char* type_name<Plate> = "hackle.plate";

const TypeDoc& plate_type();
std::span<const Function> plate_functions();

}  // namespace hackle
