// SPDX-License-Identifier: MIT
// A function of a script as what the scene takes: a field of place, or of place and time; an
// amplitude.
#pragma once

#include "console/lua/lua_function.hpp"
#include "scene/amplitude.hpp"
#include "scene/field_of_place.hpp"

namespace hackle {

// T is double or Vec2. A function with a third parameter is one of place and time, f(x, y, t);
// others are f(x, y). The field throws what LuaFunction::call throws, with the place in the
// message.
template <class T>
FieldOfPlace<T> field_of(const LuaFunction& function);

// Returns the amplitude f(t), whose text is that of the function.
Amplitude amplitude_of(const LuaFunction& function);

}  // namespace hackle
