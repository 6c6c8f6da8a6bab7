// SPDX-License-Identifier: MIT
// A recorded run as a value of scripts.
#pragma once

#include <any>
#include <memory>
#include <vector>

#include "console/lua/object.hpp"
#include "console/schema/given_value.hpp"
#include "store/recording.hpp"

namespace hackle {

struct ScriptedRecording {
  std::shared_ptr<Recording> recording;
};

template <>
inline constexpr const char* type_name<ScriptedRecording> = "hackle.recording";

using Recordings = std::vector<std::shared_ptr<Recording>>;
// Reads a list of recordings.
std::any read_recordings(const GivenValue& given);

}  // namespace hackle
