// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace hackle {

// Returns when the disk has all of a file; also if the file does not exist. Throws Error (files).
void bring_file_to_disk(const std::filesystem::path& path);

}  // namespace hackle
