// SPDX-License-Identifier: MIT
// p:contact{}: faces of cracks and fragments that push each other away.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> contact_methods();

}  // namespace hackle
