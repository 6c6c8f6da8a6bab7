// SPDX-License-Identifier: MIT
// help(), help(plate), help "crack"
#pragma once

#include "console/object_type.hpp"

namespace hackle {

std::span<const Function> help_functions();

}  // namespace hackle
