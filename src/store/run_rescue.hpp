// SPDX-License-Identifier: MIT
// Keeps the records of a killed program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

namespace hackle {

struct RescuedRun {
  std::filesystem::path file;  // "crack.cut_off.h5", with a number if that exists
  std::int64_t records = 0;
};

// Renames an incomplete run file to a name that is not `taken`, and gives it its own sidecar.
// Returns nothing if there is no file, or it is complete or has no record. The caller makes sure
// that nobody is writing it. Throws Error (files) if it cannot be renamed; it then stays as it is.
std::optional<RescuedRun> rescue_run(
    const std::filesystem::path& path,
    const std::function<bool(const std::filesystem::path&)>& taken = [](const auto&) {
      return false;
    });

}  // namespace hackle
