// SPDX-License-Identifier: MIT
// A picture as an area of the plate.
#pragma once

#include <filesystem>

#include "scene/shape.hpp"

namespace hackle {

enum class Mask { dark, light };

// The pixels of a PNG below the threshold (0 black to 1 white), or the others, laid over `area`.
// Throws what read_png throws.
Bitmap read_mask(const std::filesystem::path& path, const Box& area, Mask pixels, double threshold);

}  // namespace hackle
