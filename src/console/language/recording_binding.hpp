// SPDX-License-Identifier: MIT
// recording "run.h5" and the methods of a recorded run.
#pragma once

#include <span>

#include "console/schema/schema.hpp"
#include "output/replay.hpp"

namespace hackle {

class Arguments;

// Returns the runs of the option `recordings` with their titles; `who` names the calling function.
Tiles tiles_of(Arguments& arguments, const char* who);

const TypeDoc& recording_type();
std::span<const Function> recording_functions();

}  // namespace hackle
