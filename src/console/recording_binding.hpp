// SPDX-License-Identifier: MIT
// recording "run.h5" and what can be done with a recorded run.
#pragma once

#include <memory>
#include <span>

#include "console/object.hpp"
#include "console/schema.hpp"
#include "output/replay.hpp"
#include "store/recording.hpp"

namespace hackle {

class Arguments;

// What a script holds of one.
struct ScriptedRecording {
  std::shared_ptr<Recording> recording;
};

template <>
inline constexpr const char* type_name<ScriptedRecording> = "hackle.recording";

// The runs of the option `recordings` with their titles; `who` names the call.
Tiles tiles_of(Arguments& arguments, const char* who);

const TypeDoc& recording_type();
std::span<const Function> recording_functions();

}  // namespace hackle
