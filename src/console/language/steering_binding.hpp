// SPDX-License-Identifier: MIT
// s:on, s:stop, s:fork, s:rewind: control of a run.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> steering_methods();

}  // namespace hackle
