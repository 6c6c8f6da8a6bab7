// SPDX-License-Identifier: MIT
// A plate as scripts hold it.
#pragma once

#include "console/lua/object.hpp"
#include "scene/plate.hpp"

namespace hackle {

template <>
inline constexpr const char* type_name<Plate> = "hackle.plate";

// How every method of a plate ends: [-all, +1] its stack holds the plate alone, so that calls can
// be chained. Throws Error (script) when the script has no memory left for what was added.
int return_plate(lua_State* L);

// As destroy_object<Plate>; gives its memory back.
int destroy_plate(lua_State* L);

}  // namespace hackle
