// SPDX-License-Identifier: MIT
// Cracks at random places, like the flaws of a glass surface.
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "scene/plate.hpp"

namespace hackle {

// Straight cracks that lie wholly in a rectangle. Length, direction and place are uniform in their
// ranges; cracks that stick out are drawn again.
struct RandomCracks {
  Vec2 length{0, 0};                // m, minimum and maximum
  Vec2 angle{0, std::numbers::pi};  // rad from x anticlockwise, minimum and maximum
  Box area;                         // m
  std::int64_t seed = 1;
  int count = 0;
  Born born = Born::broken;
};

// Draws the cracks, with the same bits on every machine. Throws Error (refused) if they do not fit
// into the area.
std::vector<Crack> make(const RandomCracks& cracks);

void check(const Plate& plate, const RandomCracks& cracks, Problems& problems);

}  // namespace hackle
