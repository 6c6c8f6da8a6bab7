// SPDX-License-Identifier: MIT
// study.trade { script, ... } and its like: what hackle study does, from a script or the prompt.
#pragma once

#include "console/schema/object_type.hpp"

namespace hackle {

std::span<const Function> study_functions();

// Call this once the functions are defined: `study` then refuses names that it does not have.
void close_study(lua_State* L);

}  // namespace hackle
