// SPDX-License-Identifier: MIT
// What the cracks of a plate do to it: s:fracture, s:fragments, and those of a recording.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> fracture_methods();           // of a simulation
std::span<const Function> recorded_fracture_methods();  // of a recording

}  // namespace hackle
