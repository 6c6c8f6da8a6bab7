// SPDX-License-Identifier: MIT
// plate { ... } and everything that can be added to it.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

const TypeDoc& plate_type();
std::span<const Function> plate_functions();

}  // namespace hackle
