// SPDX-License-Identifier: MIT
// Plane geometry that shapes and cracks share. All of it treats mirror images alike, to the bit.
#pragma once

#include <vector>

#include "scene/vec2.hpp"

namespace hackle {

double cross(const Vec2& a, const Vec2& b);

// On which side of the line through `segment`, which has a length, a point lies: -1, 0 (closer
// than `tie`) or 1.
int side(const Segment& segment, const Vec2& point, double tie);

double distance(const Segment& segment, const Vec2& point);
// Of the nearest points of two segments; 0 when they cross.
double distance(const Segment& one, const Segment& other);

// Whether two segments have a point in common that is no end of `one`. On one line: whether more
// than an end of `one` lies on the other.
bool crosses(const Segment& one, const Segment& other, double tie);

// Points along an arc, its two ends included, whose chords lie within a millionth of the radius of
// it. Angles in rad from x, anticlockwise when `to` is above `from`. A whole turn ends in the very
// point where it began.
std::vector<Vec2> arc(const Vec2& centre, double radius, double from, double to);

}  // namespace hackle
