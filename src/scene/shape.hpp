// SPDX-License-Identifier: MIT
// Areas of the plane, exact and without any mesh: cut-outs, outlines, inclusions, and the regions
// of loads. Each kind is a file in shapes/.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/shapes/bitmap.hpp"
#include "scene/shapes/capsule.hpp"
#include "scene/shapes/ellipse.hpp"
#include "scene/shapes/polygon.hpp"
#include "scene/shapes/ring.hpp"

namespace hackle {

using Shape = std::variant<Ellipse, Polygon, Capsule, Ring, Bitmap>;

// The region in which something acts; nothing means the whole plate.
using Region = std::optional<Shape>;

inline constexpr About about_region{.nothing = "plate"};

Box bounds(const Shape& shape);

// Returns the shape moved so that `origin` becomes the origin, then scaled by `factor`.
Shape transformed(const Shape& shape, const Vec2& origin, double factor);

// Returns whether a point is inside and not on the rim. Points closer than `tie` to the rim lie on
// it. Mirror images give the same answers.
bool is_inside(const Shape& shape, const Vec2& point, double tie);
// Returns whether a point is inside or on the rim.
bool covers(const Shape& shape, const Vec2& point, double tie);
// Returns whether any point of a segment is inside.
bool cuts(const Shape& shape, const Segment& segment, double tie);

// Appends the places along a segment, between 0 and 1 and in any order, where it may enter or leave
// the shape: between two of them it is wholly inside, on the rim, or outside.
void add_crossings(const Shape& shape, const Segment& segment, double tie,
                   std::vector<double>& crossings);

// Returns false only if no segment in the box has a point inside. For shapes of many parts: a box
// far from all of them needs no closer look.
bool may_cut(const Shape& shape, const Box& box, double tie);

Shape rectangle(const Vec2& min, const Vec2& max);

// Returns "ellipse", "polygon", "slot", "ring" or "picture".
std::string kind_of(const Shape& shape);

// Adds a problem for every value that makes no valid area. `who` names the calling function:
// "hole".
void check(const Shape& shape, const std::string& who, Problems& problems);

}  // namespace hackle
