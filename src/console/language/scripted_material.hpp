// SPDX-License-Identifier: MIT
// A material as a value of scripts.
#pragma once

#include <any>

#include "console/lua/object.hpp"
#include "console/schema/given_value.hpp"
#include "scene/material.hpp"

namespace hackle {

template <>
inline constexpr const char* type_name<Material> = "hackle.material";

// Reads a Material: the object itself, or the one that a text names in the library.
std::any read_material(const GivenValue& given);

}  // namespace hackle
