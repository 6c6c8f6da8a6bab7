// SPDX-License-Identifier: MIT
#include "console/language/scripted_run.hpp"

#include "base/files.hpp"

namespace hackle {

void ScriptedRun::check_still_writable() const {
  for (const std::filesystem::path& path : promised) check_writable(path);
}

}  // namespace hackle
