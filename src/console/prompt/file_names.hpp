// SPDX-License-Identifier: MIT
// Lists files for the completion of paths.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hackle {

struct FileNames {
  std::size_t typed = 0;           // bytes of the last part of the path
  std::vector<std::string> names;  // entries of its folder; folders end in "/"
};

// Returns the possible continuations of a path; a relative path begins in `folder`. Hidden files
// are listed only after a dot. An unreadable folder counts as empty.
FileNames file_names(std::string_view path, const std::filesystem::path& folder);

}  // namespace hackle
