// SPDX-License-Identifier: MIT
// The format of a movie, apart from its kind, which follows from the extension of its name.
#pragma once

#include <optional>
#include <string>

#include "base/error.hpp"
#include "movie/movie_kind.hpp"

namespace hackle {

inline constexpr double max_hold = 3600.0;  // s

struct MovieFormat {
  int width = 0;      // px, even
  int height = 0;     // px, even
  double fps = 30.0;  // frames per second, from 0.1 to the limit of the kind
  Profile profile = Profile::web;
  std::optional<int> crf;  // in the range of the kind; default: set by the profile
  double hold = 0.0;       // s for which the last frame is shown again at the end, up to max_hold
  int threads = 1;         // of the encoder, at least 1
  std::string title;       // metadata; either may be empty
  std::string comment;
};

// Checks everything except the size and the threads. `path` may have any extension.
void check_settings(const std::filesystem::path& path, const MovieFormat& format,
                    Problems& problems);

// Checks everything. Throws Error (refused) with every problem.
void check(const std::filesystem::path& path, const MovieFormat& format);

}  // namespace hackle
