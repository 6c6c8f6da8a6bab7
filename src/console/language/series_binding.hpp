// SPDX-License-Identifier: MIT
// s:log and r:log: tables of numbers.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> series_methods();           // of a simulation
std::span<const Function> recorded_series_methods();  // of a recording

}  // namespace hackle
