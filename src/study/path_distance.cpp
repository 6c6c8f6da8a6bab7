// SPDX-License-Identifier: MIT
#include "study/path_distance.hpp"

#include <algorithm>
#include <limits>

namespace hackle {
namespace {

using Lines = std::vector<std::vector<Vec2>>;

double to_lines(const Vec2& point, const Lines& lines) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k)
      nearest = std::min(
          nearest, distance_to_segment(point, line[k], line[std::min(k + 1, line.size() - 1)]));
  return nearest;
}

// The distance to a line is convex along a segment only if the nearest segment stays the same, but
// points of paths lie closer than anything that matters.
double from_to(const Lines& one, const Lines& other) {
  double farthest = 0.0;
  for (const std::vector<Vec2>& line : one)
    for (const Vec2& point : line) farthest = std::max(farthest, to_lines(point, other));
  return farthest;
}

}  // namespace

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - a - share * along).norm();
}

double hausdorff_distance(const Lines& one, const Lines& other) {
  return std::max(from_to(one, other), from_to(other, one));
}

}  // namespace hackle
