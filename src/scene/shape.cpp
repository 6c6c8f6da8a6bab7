// SPDX-License-Identifier: MIT
#include "scene/shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "scene/geometry.hpp"

namespace hackle {
namespace {

// Maps a point by the map that makes the ellipse the unit circle.
Vec2 on_circle(const Ellipse& ellipse, const Vec2& point) {
  const Vec2 axis(std::cos(ellipse.angle), std::sin(ellipse.angle)), r = point - ellipse.centre;
  return Vec2(axis.dot(r), cross(axis, r)).cwiseQuotient(ellipse.radii);
}

// Returns the depth of a point inside, negative outside. Its sign is exact, its size only near the
// rim.
double depth(const Ellipse& ellipse, const Vec2& point) {
  return (1.0 - on_circle(ellipse, point).norm()) * ellipse.radii.minCoeff();
}

template <class Work>
void for_sides(const Polygon& polygon, const Work& work) {
  const std::size_t n = polygon.points.size();
  for (std::size_t k = 0; k < n; ++k) work({polygon.points[k], polygon.points[(k + 1) % n]});
}

// Returns whether the bounding box of a segment, enlarged by `margin`, meets another box.
bool is_near(const Segment& segment, const Vec2& least, const Vec2& most, double margin) {
  return std::min(segment.from.x(), segment.to.x()) <= most.x() + margin &&
         std::max(segment.from.x(), segment.to.x()) >= least.x() - margin &&
         std::min(segment.from.y(), segment.to.y()) <= most.y() + margin &&
         std::max(segment.from.y(), segment.to.y()) >= least.y() - margin;
}

// Applies the even-odd rule; undefined for points on the rim.
bool is_within(const Polygon& polygon, const Vec2& point) {
  bool within = false;
  for_sides(polygon, [&](const Segment& side) {
    const bool spans = (side.from.y() > point.y()) != (side.to.y() > point.y());
    if (!spans) return;
    const double t = (point.y() - side.from.y()) / (side.to.y() - side.from.y());
    if (point.x() < side.from.x() + t * (side.to.x() - side.from.x())) within = !within;
  });
  return within;
}

bool is_on_rim(const Polygon& polygon, const Vec2& point, double tie) {
  bool on_rim = false;
  for_sides(polygon, [&](const Segment& side) {
    if (is_near(side, point, point, tie)) on_rim = on_rim || distance(side, point) <= tie;
  });
  return on_rim;
}

double depth(const Capsule& capsule, const Vec2& point) {
  return capsule.radius - distance(capsule.axis, point);
}

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
  return (bitmap.most - bitmap.least).cwiseQuotient(Vec2(bitmap.columns, bitmap.rows));
}

// Returns the number of cells that a point touches, and how many of them are marked.
std::pair<int, int> touched(const Bitmap& bitmap, const Vec2& point, double tie) {
  const Vec2 cell = cell_of(bitmap), at = (point - bitmap.least).cwiseQuotient(cell);
  const Cells x = cells_at(at.x(), tie / cell.x()), y = cells_at(at.y(), tie / cell.y());
  int all = 0, marked = 0;
  for (std::int64_t j = y.first; j <= y.last; ++j)
    for (std::int64_t i = x.first; i <= x.last; ++i) {
      ++all;
      marked += is_marked(bitmap, i, j) ? 1 : 0;
    }
  return {all, marked};
}

bool lies_inside(const Ellipse& ellipse, const Vec2& point, double tie) {
  return depth(ellipse, point) > tie;
}
bool lies_inside(const Capsule& capsule, const Vec2& point, double tie) {
  return depth(capsule, point) > tie;
}
bool lies_inside(const Polygon& polygon, const Vec2& point, double tie) {
  return is_within(polygon, point) && !is_on_rim(polygon, point, tie);
}
bool lies_inside(const Bitmap& bitmap, const Vec2& point, double tie) {
  const auto [all, marked] = touched(bitmap, point, tie);
  return marked == all;
}

bool covers_shape(const Ellipse& ellipse, const Vec2& point, double tie) {
  return depth(ellipse, point) >= -tie;
}
bool covers_shape(const Capsule& capsule, const Vec2& point, double tie) {
  return depth(capsule, point) >= -tie;
}
bool covers_shape(const Polygon& polygon, const Vec2& point, double tie) {
  return is_within(polygon, point) || is_on_rim(polygon, point, tie);
}
bool covers_shape(const Bitmap& bitmap, const Vec2& point, double tie) {
  return touched(bitmap, point, tie).second > 0;
}

bool cuts_shape(const Ellipse& ellipse, const Segment& segment, double tie) {
  const Segment seen{on_circle(ellipse, segment.from), on_circle(ellipse, segment.to)};
  return (1.0 - distance(seen, Vec2(0, 0))) * ellipse.radii.minCoeff() > tie;
}

bool cuts_shape(const Capsule& capsule, const Segment& segment, double tie) {
  return capsule.radius - distance(capsule.axis, segment) > tie;
}

// Returns whether the midpoint of any part between these places along the segment (0 to 1) is
// inside.
template <class Area>
bool has_fragment_inside(const Area& area, const Segment& segment, std::vector<double>& meets,
                         double tie) {
  std::ranges::sort(meets);
  const Vec2 along = segment.to - segment.from;
  for (std::size_t k = 0; k + 1 < meets.size(); ++k)
    if (lies_inside(area, segment.from + 0.5 * (meets[k] + meets[k + 1]) * along, tie)) return true;
  return false;
}

// Cuts the segment at every side it meets and tests the midpoint of every part.
bool cuts_shape(const Polygon& polygon, const Segment& segment, double tie) {
  const Vec2 along = segment.to - segment.from;
  const Vec2 least = segment.from.cwiseMin(segment.to), most = segment.from.cwiseMax(segment.to);
  std::vector<double> meets{0.0, 1.0};
  for_sides(polygon, [&](const Segment& side) {
    if (!is_near(side, least, most, tie)) return;
    const Vec2 across = side.to - side.from;
    const double area = cross(along, across);
    if (area == 0.0) return;
    const double t = cross(side.from - segment.from, across) / area;
    if (t > 0.0 && t < 1.0) meets.push_back(t);
  });
  return has_fragment_inside(polygon, segment, meets, tie);
}

// Cuts the segment at every line between cells.
bool cuts_shape(const Bitmap& bitmap, const Segment& segment, double tie) {
  const Vec2 cell = cell_of(bitmap), along = segment.to - segment.from;
  std::vector<double> meets{0.0, 1.0};
  for (const int axis : {0, 1}) {
    const double from = (segment.from[axis] - bitmap.least[axis]) / cell[axis];
    const double to = (segment.to[axis] - bitmap.least[axis]) / cell[axis];
    const double last = axis == 0 ? bitmap.columns : bitmap.rows;
    if (std::abs(along[axis]) <= tie) continue;
    const auto first_line = std::clamp(std::ceil(std::min(from, to)), 0.0, last + 1.0);
    const auto last_line = std::clamp(std::floor(std::max(from, to)), -1.0, last);
    for (auto line = static_cast<int>(first_line); line <= static_cast<int>(last_line); ++line)
      meets.push_back(std::clamp((line - from) / (to - from), 0.0, 1.0));
  }
  return has_fragment_inside(bitmap, segment, meets, tie);
}

// Returns whether the box shares a point with a marked cell.
bool has_marked(const Bitmap& bitmap, const Box& box) {
  const Vec2 cell = cell_of(bitmap);
  const Vec2 last_cell(bitmap.columns - 1, bitmap.rows - 1);
  const Vec2 from = (box.least - bitmap.least).cwiseQuotient(cell).array().floor().cwiseMax(0.0);
  const Vec2 to =
      (box.most - bitmap.least).cwiseQuotient(cell).array().floor().matrix().cwiseMin(last_cell);
  if (!(from.x() <= to.x() && from.y() <= to.y())) return false;
  const auto first = static_cast<std::size_t>(from.x()), last = static_cast<std::size_t>(to.x());
  for (auto j = static_cast<std::size_t>(from.y()); j <= static_cast<std::size_t>(to.y()); ++j) {
    const std::uint8_t* row =
        bitmap.inside.data() + j * static_cast<std::size_t>(bitmap.columns) + first;
    if (std::memchr(row, 1, last - first + 1) != nullptr) return true;
  }
  return false;
}

Box bounds_of(const Ellipse& ellipse) {
  const Vec2 a = ellipse.radii.x() * Vec2(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Vec2 b = ellipse.radii.y() * Vec2(-std::sin(ellipse.angle), std::cos(ellipse.angle));
  const Vec2 half = (a.cwiseAbs2() + b.cwiseAbs2()).cwiseSqrt();
  return {ellipse.centre - half, ellipse.centre + half};
}

Box bounds_of(const Polygon& polygon) {
  Box box{polygon.points.front(), polygon.points.front()};
  for (const Vec2& point : polygon.points)
    box = {box.least.cwiseMin(point), box.most.cwiseMax(point)};
  return box;
}

// Returns whether all points lie on one line, up to rounding.
bool is_flat(const Polygon& polygon) {
  const Vec2& first = polygon.points.front();
  const auto away = [&](const Vec2& p) { return (p - first).squaredNorm(); };
  const Vec2 far = *std::ranges::max_element(polygon.points, {}, away);
  const Vec2 along = far - first;
  return std::ranges::all_of(polygon.points, [&](const Vec2& p) {
    return std::abs(cross(along, p - first)) <= 1e-12 * along.squaredNorm();
  });
}

Box bounds_of(const Capsule& capsule) {
  const Vec2 radius = Vec2::Constant(capsule.radius);
  return {capsule.axis.from.cwiseMin(capsule.axis.to) - radius,
          capsule.axis.from.cwiseMax(capsule.axis.to) + radius};
}

Box bounds_of(const Bitmap& bitmap) {
  return {bitmap.least, bitmap.most};
}

}  // namespace

Box bounds(const Shape& shape) {
  return std::visit([](const auto& s) { return bounds_of(s); }, shape);
}

Shape transformed(const Shape& shape, const Vec2& origin, double factor) {
  const auto point = [&](const Vec2& p) -> Vec2 { return (p - origin) * factor; };
  struct Transform {
    const decltype(point)& move;
    double factor;
    Shape operator()(const Ellipse& s) const {
      return Ellipse{move(s.centre), s.radii * factor, s.angle};
    }
    Shape operator()(Polygon s) const {
      std::ranges::transform(s.points, s.points.begin(), move);
      return s;
    }
    Shape operator()(const Capsule& s) const {
      return Capsule{{move(s.axis.from), move(s.axis.to)}, s.radius * factor};
    }
    Shape operator()(Bitmap s) const {
      s.least = move(s.least);
      s.most = move(s.most);
      return s;
    }
  };
  return std::visit(Transform{point, factor}, shape);
}

bool is_inside(const Shape& shape, const Vec2& point, double tie) {
  return std::visit([&](const auto& s) { return lies_inside(s, point, tie); }, shape);
}

bool covers(const Shape& shape, const Vec2& point, double tie) {
  return std::visit([&](const auto& s) { return covers_shape(s, point, tie); }, shape);
}

bool cuts(const Shape& shape, const Segment& segment, double tie) {
  return std::visit([&](const auto& s) { return cuts_shape(s, segment, tie); }, shape);
}

bool may_cut(const Shape& shape, const Box& box, double tie) {
  if (const auto* polygon = std::get_if<Polygon>(&shape)) {
    bool near = is_within(*polygon, box.least);
    for_sides(*polygon,
              [&](const Segment& side) { near = near || is_near(side, box.least, box.most, tie); });
    return near;
  }
  if (const auto* bitmap = std::get_if<Bitmap>(&shape)) return has_marked(*bitmap, box);
  return true;
}

Shape rectangle(const Vec2& least, const Vec2& most) {
  return Polygon{{least, {most.x(), least.y()}, most, {least.x(), most.y()}}};
}

std::string kind_of(const Shape& shape) {
  return std::visit(
      [](const auto& kind) {
        return std::string(description_of<std::remove_cvref_t<decltype(kind)>>.noun);
      },
      shape);
}

void check(const Shape& shape, const std::string& who, Problems& problems) {
  if (const auto* polygon = std::get_if<Polygon>(&shape); polygon && polygon->points.size() < 3)
    return problems.add(fmt::format("{}: a polygon has at least three points", who));
  const Box box = bounds(shape);
  const Vec2 size = box.most - box.least;
  const bool sized = size.allFinite() && size.minCoeff() > 0.0;
  const auto* polygon = std::get_if<Polygon>(&shape);
  if (sized && (polygon == nullptr || !is_flat(*polygon))) return;
  problems.add(fmt::format("{}: the {} has no area", who, kind_of(shape)),
               "give it a size in both directions");
}

}  // namespace hackle
