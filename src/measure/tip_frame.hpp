// SPDX-License-Identifier: MIT
// Where a crack ends and which way it points: the frame in which fracture mechanics measures.
#pragma once

#include <optional>

#include "solver/view.hpp"

namespace hackle {

// Places are those of the undeformed plate.
struct TipFrame {
  Vec2 tip{0, 0};    // m
  Vec2 ahead{1, 0};  // unit vector along the crack, out of it

  Vec2 normal() const { return {-ahead.y(), ahead.x()}; }  // to the left of `ahead`
  // Returns a place, or a vector, in the frame: along the crack and across it.
  Vec2 local(const Vec2& place) const { return turned(place - tip); }
  Vec2 turned(const Vec2& vector) const { return {ahead.dot(vector), normal().dot(vector)}; }
};

// Returns the tip that lies farthest along a direction, open or not at the start. It is put where
// the gaps of the nodes beside the crack (gaps.hpp) fall to half of what they are a horizon behind:
// where a straight cut ends. `ahead` leads away from the gaps within three horizons of it. Nothing
// without a crack.
std::optional<TipFrame> foremost_tip(const View& view, const Vec2& along);

// Returns the direction in which a crack points that ends at this place: away from the gaps within
// three horizons, along an axis of the lattice if it is within 2 degrees of one. Nothing without
// gaps there.
std::optional<Vec2> direction_at(const View& view, const Vec2& tip);

}  // namespace hackle
