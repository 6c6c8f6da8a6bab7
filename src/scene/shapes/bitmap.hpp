// SPDX-License-Identifier: MIT
// The dark or the light cells of a picture laid over a rectangle. The rim runs between cells that
// are inside and cells that are not.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/described.hpp"
#include "base/error.hpp"
#include "scene/shapes/box.hpp"
#include "scene/vec2.hpp"

namespace hackle {

struct Bitmap {
  Vec2 min{0, 0};  // lower left corner
  Vec2 max{0, 0};  // upper right corner
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> inside;  // row by row from the bottom, 0 or 1
  friend bool operator==(const Bitmap&, const Bitmap&) = default;
};

template <>
inline constexpr auto description_of<Bitmap> = describe_noun(
    "picture", "picture", member("from", &Bitmap::min, {.unit = "m", .required = true}),
    member("to", &Bitmap::max, {.unit = "m", .required = true}),
    member("columns", &Bitmap::columns, {.required = true}),
    member("rows", &Bitmap::rows, {.required = true}),
    member("run_lengths", &Bitmap::inside, {.required = true}));

// The functions of every shape; see shape.hpp.
Box bounds_of(const Bitmap& bitmap);
Bitmap moved(Bitmap bitmap, const Vec2& origin, double factor);
bool lies_inside(const Bitmap& bitmap, const Vec2& point, double tie);
bool covers_point(const Bitmap& bitmap, const Vec2& point, double tie);
bool cuts_segment(const Bitmap& bitmap, const Segment& segment, double tie);
bool may_cut_in(const Bitmap& bitmap, const Box& box, double tie);
void add_crossings_of(const Bitmap& bitmap, const Segment& segment, double tie,
                      std::vector<double>& crossings);
void check_shape(const Bitmap& bitmap, const std::string& who, Problems& problems);

}  // namespace hackle
