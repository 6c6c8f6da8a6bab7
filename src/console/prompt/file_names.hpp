// SPDX-License-Identifier: MIT
// Files as a person names them in a script.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hackle {

struct FileNames {
  std::size_t typed = 0;           // bytes of the last part of the path
  std::vector<std::string> names;  // of what lies in its folder; folders end in "/"
};

// What a path that is being typed may go on with; a relative one begins in `folder`. Hidden files
// only when a dot is typed. A folder that cannot be read holds nothing.
FileNames file_names(std::string_view path, const std::filesystem::path& folder);

}  // namespace hackle
