// SPDX-License-Identifier: MIT
#include "scene/shapes/bitmap.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace hackle {
namespace {

// The cells of a picture along one axis that a coordinate touches, in units of cells.
struct Cells {
  std::int64_t first, last;
};

Cells cells_at(double place, double tie) {
  const double slack = std::min(tie, 0.25);
  // No picture has that many cells: coordinates beyond are off it in any case.
  const double held = std::clamp(place, -1e9, 1e9);
  return {static_cast<std::int64_t>(std::floor(held - slack)),
          static_cast<std::int64_t>(std::floor(held + slack))};
}

bool is_marked(const Bitmap& bitmap, std::int64_t i, std::int64_t j) {
  return i >= 0 && j >= 0 && i < bitmap.columns && j < bitmap.rows &&
         bitmap.inside[static_cast<std::size_t>(j * bitmap.columns + i)] != 0;
}

Vec2 cell_of(const Bitmap& bitmap) {
  return (bitmap.max - bitmap.min).cwiseQuotient(Vec2(bitmap.columns, bitmap.rows));
}

// Returns the number of cells that a point touches, and how many of them are marked.
std::pair<int, int> touched(const Bitmap& bitmap, const Vec2& point, double tie) {
  const Vec2 cell = cell_of(bitmap), at = (point - bitmap.min).cwiseQuotient(cell);
  const Cells x = cells_at(at.x(), tie / cell.x()), y = cells_at(at.y(), tie / cell.y());
  int all = 0, marked = 0;
  for (std::int64_t j = y.first; j <= y.last; ++j)
    for (std::int64_t i = x.first; i <= x.last; ++i) {
      ++all;
      marked += is_marked(bitmap, i, j) ? 1 : 0;
    }
  return {all, marked};
}

}  // namespace

Box bounds_of(const Bitmap& bitmap) {
  return {bitmap.min, bitmap.max};
}

Bitmap moved(Bitmap bitmap, const Vec2& origin, double factor) {
  bitmap.min = moved(bitmap.min, origin, factor);
  bitmap.max = moved(bitmap.max, origin, factor);
  return bitmap;
}

bool lies_inside(const Bitmap& bitmap, const Vec2& point, double tie) {
  const auto [all, marked] = touched(bitmap, point, tie);
  return marked == all;
}

bool covers_point(const Bitmap& bitmap, const Vec2& point, double tie) {
  return touched(bitmap, point, tie).second > 0;
}

bool cuts_segment(const Bitmap& bitmap, const Segment& segment, double tie) {
  std::vector<double> crossings;
  add_crossings_of(bitmap, segment, tie, crossings);
  return any_midpoint(segment, std::move(crossings),
                      [&](const Vec2& point) { return lies_inside(bitmap, point, tie); });
}

// Returns whether the box shares a point with a marked cell.
bool may_cut_in(const Bitmap& bitmap, const Box& box, double) {
  const Vec2 cell = cell_of(bitmap);
  const Vec2 last_cell(bitmap.columns - 1, bitmap.rows - 1);
  const Vec2 from = (box.min - bitmap.min).cwiseQuotient(cell).array().floor().cwiseMax(0.0);
  const Vec2 to =
      (box.max - bitmap.min).cwiseQuotient(cell).array().floor().matrix().cwiseMin(last_cell);
  if (!(from.x() <= to.x() && from.y() <= to.y())) return false;
  const auto first = static_cast<std::size_t>(from.x()), last = static_cast<std::size_t>(to.x());
  for (auto j = static_cast<std::size_t>(from.y()); j <= static_cast<std::size_t>(to.y()); ++j) {
    const std::uint8_t* row =
        bitmap.inside.data() + j * static_cast<std::size_t>(bitmap.columns) + first;
    if (std::memchr(row, 1, last - first + 1) != nullptr) return true;
  }
  return false;
}

// Every line between cells.
void add_crossings_of(const Bitmap& bitmap, const Segment& segment, double tie,
                      std::vector<double>& crossings) {
  const Vec2 cell = cell_of(bitmap), along = segment.to - segment.from;
  for (const int axis : {0, 1}) {
    const double from = (segment.from[axis] - bitmap.min[axis]) / cell[axis];
    const double to = (segment.to[axis] - bitmap.min[axis]) / cell[axis];
    const double last = axis == 0 ? bitmap.columns : bitmap.rows;
    if (std::abs(along[axis]) <= tie) continue;
    const auto first_line = std::clamp(std::ceil(std::min(from, to)), 0.0, last + 1.0);
    const auto last_line = std::clamp(std::floor(std::max(from, to)), -1.0, last);
    for (auto line = static_cast<int>(first_line); line <= static_cast<int>(last_line); ++line)
      crossings.push_back(std::clamp((line - from) / (to - from), 0.0, 1.0));
  }
}

void check_shape(const Bitmap& bitmap, const std::string& who, Problems& problems) {
  check_area(bounds_of(bitmap), "picture", who, problems);
}

}  // namespace hackle
