// SPDX-License-Identifier: MIT
// Files of the program (shaders, assets) and safe names for the files it writes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hackle {

// The path of a file that ships with Hackle, e.g. data_file("shaders/colours.frag"). Looked for
// below $HACKLE_DATA, then in ../share/hackle beside the program, which in a build folder is a link
// to the source tree. Throws Error (files) with the places it looked in.
std::filesystem::path data_file(const std::filesystem::path& name);

// The same, or nothing.
std::optional<std::filesystem::path> find_data_file(const std::filesystem::path& name);

// The whole text of a file. Throws Error (files).
std::string read_text(const std::filesystem::path& path);

// Writes `text` under a temporary name in the same folder, then renames. Throws Error (files).
void write_text(const std::filesystem::path& path, const std::string& text);

// The name a file bears until it is complete: "a/movie.mp4" -> "a/.movie.partial.mp4".
std::filesystem::path partial_name(const std::filesystem::path& path);

// Renames the partial file of `path` to `path`. Throws Error (files).
void publish(const std::filesystem::path& path);

// Where a path leads once every link in it is followed, also of a file that does not exist yet and
// of links to nowhere (which std::filesystem::weakly_canonical leaves as they are). Absolute,
// without "." and "..". Throws Error (files) for links that go in a circle.
std::filesystem::path real_path(const std::filesystem::path& path);

// Throws Error (files) unless a file could be created at `path`: its folder, or the nearest folder
// above it that exists, must be writable. Creates nothing.
void check_writable(const std::filesystem::path& path);

// Creates the folder in which `path` lies. Throws Error (files).
void make_folder_of(const std::filesystem::path& path);

}  // namespace hackle
