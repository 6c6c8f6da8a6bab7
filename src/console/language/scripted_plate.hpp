// SPDX-License-Identifier: MIT
// A plate as a value of scripts.
#pragma once

#include "console/lua/object.hpp"
#include "scene/plate.hpp"

namespace hackle {

template <>
inline constexpr const char* type_name<Plate> = "hackle.plate";

// Ends every method of a plate: [-all, +1] leaves only the plate on the stack, so that calls can be
// chained. Throws Error (script) if the script has no memory left for the addition.
int return_plate(lua_State* L);

// Works like destroy_object<Plate>, and releases the plate's memory.
int destroy_plate(lua_State* L);

}  // namespace hackle
