// SPDX-License-Identifier: MIT
// plate { ... } and what can be put on it.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

const TypeDoc& plate_type();
std::span<const Function> plate_functions();

}  // namespace hackle
