// SPDX-License-Identifier: MIT
// Plane geometry for shapes and cracks. Mirror images give the same results, to the bit.
#pragma once

#include <vector>

#include "scene/vec2.hpp"

namespace hackle {

double cross(const Vec2& a, const Vec2& b);

// Returns on which side of the line through `segment` a point lies: -1, 0 (closer than `tie`) or 1.
// The segment must have a length.
int side(const Segment& segment, const Vec2& point, double tie);

double distance(const Segment& segment, const Vec2& point);
// Returns the smallest distance between two segments; 0 if they cross.
double distance(const Segment& one, const Segment& other);

// Returns whether two segments share a point that is not an end of `one`. For segments on one line:
// whether more than an end of `one` lies on `other`.
bool crosses(const Segment& one, const Segment& other, double tie);

// Returns points along an arc, both ends included, so close that chords deviate from it by less
// than a millionth of the radius. Angles in rad from x, anticlockwise if `to` is above `from`. A
// full turn ends exactly at its first point.
std::vector<Vec2> arc(const Vec2& centre, double radius, double from, double to);

}  // namespace hackle
