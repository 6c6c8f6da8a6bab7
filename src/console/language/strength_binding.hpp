// SPDX-License-Identifier: MIT
// p:strength { ... }
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> strength_methods();

}  // namespace hackle
