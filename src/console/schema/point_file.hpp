// SPDX-License-Identifier: MIT
// Lists of points in text files, as spreadsheets and digitisers write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/vec2.hpp"

namespace hackle {

inline constexpr std::uintmax_t max_point_file = 1 << 20;  // bytes

// Returns the points of a text of lines "x, y", separated by a comma, a semicolon, tabs or blanks.
// Empty lines and those that begin with # are skipped, and so is a first line without any number.
// Throws Error (files), with the line, for any other line, a number that is not finite, and more
// than `most` points. `who` names the file in messages, which quote nothing of it.
std::vector<Vec2> points_in_text(std::string_view text, std::size_t max, const std::string& who);

// Returns the points of a file. Also throws Error (files) for what is no plain file, and for one
// larger than max_point_file.
std::vector<Vec2> read_point_file(const std::filesystem::path& path, std::size_t max);

}  // namespace hackle
