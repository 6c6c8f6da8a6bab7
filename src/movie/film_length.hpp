// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hackle {

// The length of a movie.
struct FilmLength {
  std::int64_t frames = 0;
  double seconds = 0.0;  // of played time, up to the end of the last frame
};

}  // namespace hackle
