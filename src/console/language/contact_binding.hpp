// SPDX-License-Identifier: MIT
// p:contact{}: repulsion between faces of cracks and fragments.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> contact_methods();

}  // namespace hackle
