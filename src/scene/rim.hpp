// SPDX-License-Identifier: MIT
// The rims of shapes as chains of straight pieces, for loads that act along them.
#pragma once

#include <optional>
#include <vector>

#include "scene/shape.hpp"

namespace hackle {

// Points in the order of a rim; a closed chain ends at its first point.
using Chain = std::vector<Vec2>;

// Returns the rim of a shape: chords that deviate from an arc by less than a millionth of its
// radius.
std::vector<Chain> rims_of(const Shape& shape);

// Returns the parts of a segment that are seen from `middle` between two angles, rad from x
// anticlockwise, in either order. Cut exactly at the angles.
std::vector<Segment> parts_between(const Segment& segment, const Vec2& middle, const Vec2& angles);

// Calls visit(segment) for the parts of a chain between two angles, likewise; for the whole chain
// without angles.
template <class Visit>
void for_each_between(const Chain& chain, const Vec2& middle, const std::optional<Vec2>& angles,
                      const Visit& visit) {
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    const Segment whole{chain[k], chain[k + 1]};
    if (!angles)
      visit(whole);
    else
      for (const Segment& part : parts_between(whole, middle, *angles)) visit(part);
  }
}

}  // namespace hackle
