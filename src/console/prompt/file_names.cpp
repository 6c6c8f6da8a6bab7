// SPDX-License-Identifier: MIT
#include "console/prompt/file_names.hpp"

namespace hackle {

namespace fs = std::filesystem;

FileNames file_names(std::string_view path, const fs::path& folder) {
  const std::size_t slash = path.rfind('/');
  const std::size_t begin = slash == std::string_view::npos ? 0 : slash + 1;
  const std::string_view typed = path.substr(begin);
  FileNames found{typed.size(), {}};
  const fs::path place = (folder.empty() ? "." : folder) / fs::path(path.substr(0, begin));
  std::error_code failure;
  for (fs::directory_iterator at(place, failure), end; !failure && at != end;
       at.increment(failure)) {
    std::string name = at->path().filename().string();
    if (!name.starts_with(typed) || (name.starts_with('.') && typed.empty())) continue;
    std::error_code ignored;
    if (at->is_directory(ignored)) name += '/';
    found.names.push_back(std::move(name));
  }
  return found;
}

}  // namespace hackle
