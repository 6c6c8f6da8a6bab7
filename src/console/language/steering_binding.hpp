// SPDX-License-Identifier: MIT
// s:on, s:stop, s:fork, s:rewind: what a person does with a run besides letting it go on.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> steering_methods();

}  // namespace hackle
