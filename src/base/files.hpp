// SPDX-License-Identifier: MIT
// Files that ship with the program (shaders, assets), and safe names for the files it writes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hackle {

// Returns the path of a file that ships with Hackle, e.g. data_file("shaders/colours.frag").
// Searches $HACKLE_DATA, then ../share/hackle beside the program, which in a build folder is a link
// to the source tree. Throws Error (files), which lists the places searched.
std::filesystem::path data_file(const std::filesystem::path& name);

// Does the same, but returns nothing if the file is not found.
std::optional<std::filesystem::path> find_data_file(const std::filesystem::path& name);

// Returns the whole text of a file. Throws Error (files).
std::string read_text(const std::filesystem::path& path);

// Writes `text` under a temporary name in the same folder, then renames. Throws Error (files).
void write_text(const std::filesystem::path& path, const std::string& text);

// Returns the name of a file until it is complete: "a/movie.mp4" -> "a/.movie.partial.mp4".
std::filesystem::path partial_name(const std::filesystem::path& path);

// Renames the partial file of `path` to `path`. Throws Error (files).
void publish(const std::filesystem::path& path);

// Returns the absolute path without ".", ".." or links. It also resolves files that do not exist
// yet and links that lead nowhere (std::filesystem::weakly_canonical leaves those as they are).
// Throws Error (files) if links form a circle.
std::filesystem::path real_path(const std::filesystem::path& path);

// Throws Error (files) unless a file could be created at `path`: its folder, or the nearest folder
// above it that exists, must be writable. Creates nothing.
void check_writable(const std::filesystem::path& path);

// Creates the folder that contains `path`. Throws Error (files).
void make_folder_of(const std::filesystem::path& path);

}  // namespace hackle
