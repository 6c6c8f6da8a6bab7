// SPDX-License-Identifier: MIT
// What a program that was killed had filmed.
#pragma once

#include <functional>
#include <optional>

#include "movie/remux.hpp"

namespace hackle {

struct Rescued {
  std::filesystem::path file;  // "crack.cut_off.mp4", or with a number when there is one already
  FilmLength length;
};

// Makes of the partial file of `path` a complete movie beside it and removes the partial file.
// Nothing when there is none, no frame is in it, or a living program is writing it. It gets no name
// that is `taken`. Throws Error (files) when the movie cannot be written; the partial file then
// stays.
std::optional<Rescued> rescue(
    const std::filesystem::path& path,
    const std::function<bool(const std::filesystem::path&)>& taken = [](const auto&) {
      return false;
    });

}  // namespace hackle
