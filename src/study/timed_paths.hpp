// SPDX-License-Identifier: MIT
// Paths of cracks with the times at which they grew, and until when those of two runs agree.
#pragma once

#include <optional>
#include <vector>

#include "scene/vec2.hpp"
#include "study/case.hpp"

namespace hackle {

struct TimedPoint {
  Vec2 place{0, 0};   // m
  double time = 0.0;  // s, when the tip came there
};

struct TimedPaths {
  std::vector<std::vector<TimedPoint>> grown;  // each in order of time
  std::vector<std::vector<Vec2>> initial;      // m, the cracks of the scene
  double rayleigh = 0.0;                       // m/s, speed of Rayleigh waves

  bool empty() const { return grown.empty(); }
};

// Returns the paths that a run tells of (hackle run --json --sample); none of a run that did not
// finish.
TimedPaths timed_paths_of(const Outcome& outcome);

// How near is near: a path agrees with another if each of its points is `within` of the other, at
// the latest when the other has grown on for the time in which Rayleigh waves go that far.
struct Nearness {
  double within = 0.0;  // m
  double lag(const TimedPaths& other) const {
    return other.rayleigh > 0.0 ? within / other.rayleigh : 0.0;
  }
};

// The first point of either that is far from the other; nothing if all agree.
std::optional<TimedPoint> parting(const TimedPaths& one, const TimedPaths& other,
                                  const Nearness& near);

// Returns how far two runs are apart at a time, m: the largest distance of a point that either has
// come to from what the other has cracked, or will within the lag. Infinite if one of them has
// cracked nothing.
double distance_at(double time, const TimedPaths& one, const TimedPaths& other,
                   const Nearness& near);

}  // namespace hackle
