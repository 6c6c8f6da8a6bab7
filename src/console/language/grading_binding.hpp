// SPDX-License-Identifier: MIT
// p:grade
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> grading_methods();

}  // namespace hackle
