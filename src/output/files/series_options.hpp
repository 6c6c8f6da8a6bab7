// SPDX-License-Identifier: MIT
// The user's options for a table of a run.
#pragma once

#include <optional>

#include "base/described.hpp"
#include "scene/vec2.hpp"

namespace hackle {

struct SeriesOptions {
  std::optional<double> every;  // simulated seconds between rows; none: every step
  Vec2 along{1.0, 0.0};         // direction in which the tip of a crack is the farthest
};

template <>
inline constexpr auto description_of<SeriesOptions> = describe_noun(
    "log", "log",
    member("every", &SeriesOptions::every,
           {.unit = "s",
            .range = above(0.0),
            .fallback = "every step",
            .sentence = "Simulated time between rows; without it every step, or increment of slow "
                        "loading, has one."}),
    member("along", &SeriesOptions::along,
           {.fallback = "{1, 0}",
            .sentence = "Direction in which the tip of a crack is the farthest point of it."}));

}  // namespace hackle
