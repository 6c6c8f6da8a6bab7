// SPDX-License-Identifier: MIT
// Files that are not complete yet, and who writes them.
#pragma once

#include <filesystem>
#include <functional>

#include "base/file_lock.hpp"

namespace hackle {

// The partial file of `path`, see partial_name(); gone when nothing comes of it.
class PartialFile : public HeldFile {
 public:
  explicit PartialFile(const std::filesystem::path& path);
};

// Where what a killed run left of `path` is kept: "a/movie.mp4" -> "a/movie.cut_off.mp4", or with a
// number: the first that does not exist and is not `taken`.
std::filesystem::path cut_off_name(
    const std::filesystem::path& path,
    const std::function<bool(const std::filesystem::path&)>& taken = [](const auto&) {
      return false;
    });

// What is locked while a run file is recorded: "a/run.h5" -> "a/.run.recording". Files that differ
// in their ending share it, as they share a sidecar.
std::filesystem::path recording_lock(const std::filesystem::path& run_file);

// Throws Error (files) when a program, this one included, is writing `path`: itself, as a movie, or
// as a run file or its sidecar. Creates and changes nothing.
void refuse_if_written(const std::filesystem::path& path);

}  // namespace hackle
