// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace hackle {

// A point or vector of the plane; the unit is said where it is used.
using Vec2 = Eigen::Vector2d;

}  // namespace hackle
