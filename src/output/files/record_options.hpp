// SPDX-License-Identifier: MIT
// The user's options for a run file.
#pragma once

#include "output/files/movie_options.hpp"

namespace hackle {

struct RecordOptions {
  double every = 0.0;  // simulated seconds between records, less than a step is a step
};

template <>
inline constexpr auto description_of<RecordOptions> =
    describe_noun("record", "record", member("every", &RecordOptions::every, about_every));

}  // namespace hackle
