// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace hackle {

// A point or vector of the plane; its unit is stated where it is used.
using Vec2 = Eigen::Vector2d;

// A straight segment between two points, which may coincide.
struct Segment {
  Vec2 from{0, 0};
  Vec2 to{0, 0};
  friend bool operator==(const Segment&, const Segment&) = default;
};

}  // namespace hackle
