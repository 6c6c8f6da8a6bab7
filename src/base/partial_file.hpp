// SPDX-License-Identifier: MIT
// Files that are not complete yet, and their writers.
#pragma once

#include <filesystem>
#include <functional>

#include "base/file_lock.hpp"

namespace hackle {

// The partial file of `path`, see partial_name(); it is removed unless it is completed.
class PartialFile : public HeldFile {
 public:
  explicit PartialFile(const std::filesystem::path& path);
};

// Returns the name under which the remains of `path` from a killed run are kept: "a/movie.mp4" ->
// "a/movie.cut_off.mp4", with a number if needed: the first name that neither exists nor is
// `taken`.
std::filesystem::path cut_off_name(
    const std::filesystem::path& path,
    const std::function<bool(const std::filesystem::path&)>& taken = [](const auto&) {
      return false;
    });

// Returns the file that is locked while a run file is recorded: "a/run.h5" -> "a/.run.recording".
// Files that differ only in their extension share it, as they share a sidecar.
std::filesystem::path recording_lock(const std::filesystem::path& run_file);

// Throws Error (files) if a program, this one included, is writing `path`: the file itself, a
// movie, or a run file or its sidecar. Creates and changes nothing.
void refuse_if_written(const std::filesystem::path& path);

}  // namespace hackle
