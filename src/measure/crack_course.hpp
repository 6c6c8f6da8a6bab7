// SPDX-License-Identifier: MIT
// How fast the tip of a crack runs along its path.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace hackle {

// The way of a tip and when it came there: both ascend.
struct TipCourse {
  std::vector<double> ways;   // m
  std::vector<double> times;  // s

  std::size_t size() const { return ways.size(); }
};

// Returns the speed at point k, m/s: the slope of the straight line with the least squares through
// way against time over the last `window`, m, of the way. Nothing where fewer than three moments
// lie in it.
std::optional<double> speed_at(const TipCourse& course, std::size_t k, double window);
// The same at the end, seen at `time`: while the tip stays longer at a place than it took for each
// of `spacing`, m, on average, the speed falls towards 0.
double speed_now(const TipCourse& course, double window, double time, double spacing);
// Returns the largest speed at a point from `first` on, behind which lies a whole window.
std::optional<double> max_speed(const TipCourse& course, double window, std::size_t first = 0);

}  // namespace hackle
