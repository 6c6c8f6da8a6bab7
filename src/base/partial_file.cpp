// SPDX-License-Identifier: MIT
#include "base/partial_file.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "base/files.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

// Returns whether a recording writes this file, as the run file or its sidecar. It does not write a
// picture with the same stem.
bool is_recorded(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".h5" || ending == ".hdf5" || ending == ".xdmf";
}

}  // namespace

PartialFile::PartialFile(const fs::path& path) : HeldFile(partial_name(path), path) {
}

fs::path cut_off_name(const fs::path& path, const std::function<bool(const fs::path&)>& taken) {
  for (int number = 1;; ++number) {
    const std::string which = number == 1 ? "" : fmt::format("_{}", number);
    fs::path name = path.parent_path() /
                    (path.stem().string() + ".cut_off" + which + path.extension().string());
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(name, ignored)) && !taken(name)) return name;
  }
}

fs::path recording_lock(const fs::path& run_file) {
  return run_file.parent_path() / ("." + run_file.stem().string() + ".recording");
}

void refuse_if_written(const fs::path& path) {
  for (const fs::path& name : {path, partial_name(path)})
    if (is_locked(name)) refuse_locked(path, name);
  const fs::path recording = recording_lock(path);
  if (is_recorded(path) && is_locked(recording)) refuse_locked(path, recording);
}

}  // namespace hackle
