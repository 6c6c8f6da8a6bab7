// SPDX-License-Identifier: MIT
#include "console/language/scripted_recording.hpp"

#include <fmt/format.h>

namespace hackle {

std::any read_recordings(const GivenValue& given) {
  lua_State* L = given.L;
  if (!given.is_list()) return {};
  Recordings recordings;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, given.index); ++k) {
    lua_rawgeti(L, given.index, static_cast<lua_Integer>(k));
    const auto* scripted = object_at<ScriptedRecording>(L, -1);
    if (scripted != nullptr) recordings.push_back(scripted->recording);
    lua_pop(L, 1);
    if (scripted == nullptr)
      return given.wrong(
          fmt::format("{}: entry {} of {} is no recording", given.doc.name, k, given.option.name),
          "recording \"run.h5\" opens one");
  }
  return recordings;
}

}  // namespace hackle
