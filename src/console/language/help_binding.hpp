// SPDX-License-Identifier: MIT
// help(), help(plate), help "crack"
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> help_functions();

}  // namespace hackle
