// SPDX-License-Identifier: MIT
// What a program that was killed had recorded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

namespace hackle {

struct RescuedRun {
  std::filesystem::path file;  // "crack.cut_off.h5", or with a number when there is one already
  std::int64_t records = 0;
};

// Renames a run file that is not complete to a name that is not `taken`, and gives it a sidecar of
// its own. Nothing when there is none, it is complete, or it holds no record. The caller sees to it
// that nobody writes it. Throws Error (files) when it cannot be renamed; it then stays.
std::optional<RescuedRun> rescue_run(
    const std::filesystem::path& path,
    const std::function<bool(const std::filesystem::path&)>& taken = [](const auto&) {
      return false;
    });

}  // namespace hackle
