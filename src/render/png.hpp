// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "base/image.hpp"

namespace hackle {

// Writes a PNG under a partial name, then renames it. Throws Error (files), and Error (interrupted)
// on Ctrl-C.
void write_png(const Image& image, const std::filesystem::path& path);

}  // namespace hackle
