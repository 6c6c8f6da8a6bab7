// SPDX-License-Identifier: MIT
// A picture of lines, areas and texts in a file: PDF or SVG.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string_view>

#include "render/overlay/canvas.hpp"

namespace hackle {

inline constexpr auto vector_endings = std::to_array<std::string_view>({".pdf", ".svg"});

// Returns whether the path ends in one of these.
bool is_vector_file(const std::filesystem::path& path);

// The size of a page.
struct Page {
  int width = 0, height = 0;  // px
  double dpi = 300.0;         // px per inch of paper
};

// Writes one page of what `draw` draws under a partial name, then renames it. Throws Error (files),
// and Error (interrupted) on Ctrl-C.
void write_vectors(const std::filesystem::path& path, const Page& page,
                   const std::function<void(Canvas&)>& draw);

}  // namespace hackle
