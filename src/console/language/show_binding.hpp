// SPDX-License-Identifier: MIT
// show(s): shows the picture of a simulation in the terminal.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> show_functions();
std::span<const Function> show_methods();

}  // namespace hackle
