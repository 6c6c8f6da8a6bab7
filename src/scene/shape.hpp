// SPDX-License-Identifier: MIT
// Areas of the plane, exact and without any mesh: cut-outs, inclusions, and the regions of loads.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/described.hpp"
#include "base/error.hpp"
#include "scene/vec2.hpp"

namespace hackle {

struct Ellipse {
  Vec2 centre{0, 0};
  Vec2 radii{0, 0};    // half axes, > 0
  double angle = 0.0;  // rad, first half axis from x, anticlockwise
  friend bool operator==(const Ellipse&, const Ellipse&) = default;
};

inline constexpr double max_points = 10000;  // per polygon or crack

// Any closed chain of straight sides, convex or not; the even-odd rule decides what is inside.
struct Polygon {
  std::vector<Vec2> points;  // at least three
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

// All points within `radius` of a segment: a slot with round ends.
struct Capsule {
  Segment axis;
  double radius = 0.0;  // > 0
  friend bool operator==(const Capsule&, const Capsule&) = default;
};

// The dark or the light cells of a picture laid over a rectangle. The rim runs between cells that
// are inside and cells that are not.
struct Bitmap {
  Vec2 least{0, 0};  // lower left corner
  Vec2 most{0, 0};   // upper right corner
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> inside;  // row by row from the bottom, 0 or 1
  friend bool operator==(const Bitmap&, const Bitmap&) = default;
};

using Shape = std::variant<Ellipse, Polygon, Capsule, Bitmap>;

// The region in which something acts; nothing means the whole plate.
using Region = std::optional<Shape>;

inline constexpr About about_region{.nothing = "plate"};

template <>
inline constexpr auto description_of<Ellipse> = describe_noun(
    "ellipse", "ellipse", member("centre", &Ellipse::centre, {.unit = "m", .required = true}),
    member("radii", &Ellipse::radii, {.unit = "m", .required = true}),
    member("angle", &Ellipse::angle, {.unit = "rad", .fallback = "0"}));

template <>
inline constexpr auto description_of<Polygon> =
    describe_noun("polygon", "polygon",
                  member("points", &Polygon::points,
                         {.unit = "m", .range = between(3, max_points), .required = true}));

template <>
inline constexpr auto description_of<Segment> = describe_noun(
    "segment", "segment", member("from", &Segment::from, {.unit = "m", .required = true}),
    member("to", &Segment::to, {.unit = "m", .required = true}));

template <>
inline constexpr auto description_of<Capsule> =
    describe_noun("slot", "slot", member("", &Capsule::axis),
                  member("radius", &Capsule::radius, {.unit = "m", .required = true}));

template <>
inline constexpr auto description_of<Bitmap> = describe_noun(
    "picture", "picture", member("from", &Bitmap::least, {.unit = "m", .required = true}),
    member("to", &Bitmap::most, {.unit = "m", .required = true}),
    member("columns", &Bitmap::columns, {.required = true}),
    member("rows", &Bitmap::rows, {.required = true}),
    member("run_lengths", &Bitmap::inside, {.required = true}));

struct Box {
  Vec2 least{0, 0};
  Vec2 most{0, 0};
};
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

// Returns false only if no segment in the box has a point inside. For shapes of many parts: a box
// far from all of them needs no closer look.
bool may_cut(const Shape& shape, const Box& box, double tie);

Shape rectangle(const Vec2& least, const Vec2& most);

// Returns "ellipse", "polygon", "slot" or "picture".
std::string kind_of(const Shape& shape);

// Adds a problem for every value that makes no valid area. `who` names the calling function:
// "hole".
void check(const Shape& shape, const std::string& who, Problems& problems);

}  // namespace hackle
