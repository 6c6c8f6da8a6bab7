// SPDX-License-Identifier: MIT
// Keeps the movie of a killed program.
#pragma once

#include <functional>
#include <optional>

#include "movie/remux.hpp"

namespace hackle {

struct Rescued {
  std::filesystem::path file;  // "crack.cut_off.mp4", with a number if that exists
  FilmLength length;
};

// Turns the partial file of `path` into a complete movie beside it and removes the partial file.
// Returns nothing if there is none, it has no frame, or a running program is writing it. The name
// is never one that is `taken`. Throws Error (files) if the movie cannot be written; the partial
// file then stays.
std::optional<Rescued> rescue(
    const std::filesystem::path& path,
    const std::function<bool(const std::filesystem::path&)>& taken = [](const auto&) {
      return false;
    });

}  // namespace hackle
