// SPDX-License-Identifier: MIT
// The user's options for a movie.
#pragma once

#include <optional>

#include "movie/movie_format.hpp"
#include "output/picture/picture.hpp"

namespace hackle {

struct MovieOptions {
  PictureOptions picture;
  double every = 0.0;  // simulated seconds between frames; less than a step is a step
  double fps = 30.0;   // frames a second when played, no more than its kind can say
  Profile profile = Profile::web;
  std::optional<int> crf;  // in the range of the kind; default: set by the profile
  double hold = 1.0;       // s of played time for which the last frame stays
  bool fallback = false;   // use the next best kind if an encoder is missing
};

// From a frame or a record to the next.
inline constexpr About about_every{.unit = "s",
                                   .range = above(0.0),
                                   .required = true,
                                   .sentence =
                                       "Simulated time between frames or records; less than a step "
                                       "means every step."};

template <>
inline constexpr auto description_of<MovieOptions> = describe_noun(
    "movie", "movie", member("every", &MovieOptions::every, about_every),
    member("fps", &MovieOptions::fps,
           {.range = between(1.0, 240.0),
            .fallback = "30",
            .sentence = "Frames per second when played; in .gif at most 50, to 1/100 s."}),
    member("profile", &MovieOptions::profile,
           {.fallback = "web", .sentence = "Quality of the movie; some kinds can be lossless."}),
    member("crf", &MovieOptions::crf,
           {.range = between(1.0, 63.0),
            .fallback = "18 in .mp4, 28 in .webm",
            .sentence = "Constant rate factor; lower is better and larger; up to 51 in .mp4, in "
                        "others none."}),
    member("hold", &MovieOptions::hold,
           {.unit = "s",
            .range = between(0.0, max_hold),
            .fallback = "1",
            .sentence = "Time for which the last frame stays when played."}),
    member("fallback", &MovieOptions::fallback,
           {.fallback = "false",
            .sentence = "Uses the next best kind of file if an encoder is missing."}),
    member("", &MovieOptions::picture));

// Returns the slow-motion factor of a movie.
inline double slow_motion_of(const MovieOptions& options) {
  return 1.0 / (options.every * options.fps);
}

}  // namespace hackle
