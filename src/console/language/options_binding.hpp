// SPDX-License-Identifier: MIT
// options { name = default, ... }: declares what the user may set with --set name=value.
#pragma once

#include "console/schema/object_type.hpp"

namespace hackle {

std::span<const Function> options_functions();

}  // namespace hackle
