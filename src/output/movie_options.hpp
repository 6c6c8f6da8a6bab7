// SPDX-License-Identifier: MIT
// What a user asks of a movie.
#pragma once

#include <optional>

#include "movie/movie_kind.hpp"
#include "output/picture.hpp"

namespace hackle {

struct MovieOptions {
  PictureOptions picture;
  double every = 0.0;  // simulated seconds from frame to frame, at least a step
  double fps = 30.0;   // frames a second when played, 1..240 and no more than its kind can say
  Profile profile = Profile::web;
  std::optional<int> crf;  // in the range of the kind; what the profile sets if not given
  double hold = 1.0;       // s of played time for which the last frame stays
  bool fallback = false;   // to the next best kind when an encoder is missing
};

// How many times slower than it was a movie shows what happened.
inline double slow_motion_of(const MovieOptions& options) {
  return 1.0 / (options.every * options.fps);
}

}  // namespace hackle
