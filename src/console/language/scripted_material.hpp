// SPDX-License-Identifier: MIT
// A material as scripts hold and give it.
#pragma once

#include <any>

#include "console/lua/object.hpp"
#include "console/schema/given_value.hpp"
#include "scene/material.hpp"

namespace hackle {

template <>
inline constexpr const char* type_name<Material> = "hackle.material";

// A Material: the object itself, or the one of the library that a text names.
std::any read_material(const GivenValue& given);

}  // namespace hackle
