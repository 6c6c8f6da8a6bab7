// SPDX-License-Identifier: MIT
#include "scene/rim.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "scene/geometry.hpp"

namespace hackle {
namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;

Chain closed(Chain chain) {
  chain.push_back(chain.front());
  return chain;
}

std::vector<Chain> chains_of(const Ellipse& ellipse) {
  const Vec2 axis(std::cos(ellipse.angle), std::sin(ellipse.angle));
  Chain chain = arc({0, 0}, 1.0, 0.0, whole_turn);
  for (Vec2& point : chain) {
    const Vec2 along = ellipse.radii.cwiseProduct(point);
    point = ellipse.centre + along.x() * axis + along.y() * Vec2(-axis.y(), axis.x());
  }
  return {chain};
}

std::vector<Chain> chains_of(const Polygon& polygon) {
  return {closed(polygon.points)};
}

std::vector<Chain> chains_of(const Capsule& capsule) {
  const Vec2 along = capsule.axis.to - capsule.axis.from;
  const double ahead = std::atan2(along.y(), along.x()), quarter = 0.25 * whole_turn;
  Chain chain = arc(capsule.axis.to, capsule.radius, ahead - quarter, ahead + quarter);
  for (const Vec2& point :
       arc(capsule.axis.from, capsule.radius, ahead + quarter, ahead + 3.0 * quarter))
    chain.push_back(point);
  return {closed(std::move(chain))};
}

std::vector<Chain> chains_of(const Ring& ring) {
  return {arc(ring.centre, ring.outer, 0.0, whole_turn),
          arc(ring.centre, ring.inner, 0.0, whole_turn)};
}

// The sides between cells that are inside and cells that are not.
std::vector<Chain> chains_of(const Bitmap& bitmap) {
  const Vec2 cell = (bitmap.max - bitmap.min).cwiseQuotient(Vec2(bitmap.columns, bitmap.rows));
  const auto is_inside = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < bitmap.columns && j < bitmap.rows &&
           bitmap.inside[static_cast<std::size_t>(j) * static_cast<std::size_t>(bitmap.columns) +
                         static_cast<std::size_t>(i)] != 0;
  };
  const auto corner = [&](int i, int j) {
    return Vec2(bitmap.min + cell.cwiseProduct(Vec2(i, j)));
  };
  std::vector<Chain> chains;
  for (int j = 0; j <= bitmap.rows; ++j)
    for (int i = 0; i <= bitmap.columns; ++i) {
      if (is_inside(i - 1, j) != is_inside(i, j))
        chains.push_back({corner(i, j), corner(i, j + 1)});
      if (is_inside(i, j - 1) != is_inside(i, j))
        chains.push_back({corner(i, j), corner(i + 1, j)});
    }
  return chains;
}

// Appends the place along a segment where it meets the ray from `middle` at an angle.
void add_crossing_of_ray(const Segment& segment, const Vec2& middle, double angle,
                         std::vector<double>& crossings) {
  const Vec2 ray(std::cos(angle), std::sin(angle));
  const double from = cross(ray, segment.from - middle), to = cross(ray, segment.to - middle);
  if (from * to >= 0.0) return;
  const double place = from / (from - to);
  if (ray.dot(segment.from + place * (segment.to - segment.from) - middle) > 0.0)
    crossings.push_back(place);
}

bool lies_between(const Vec2& from_middle, const Vec2& angles) {
  const auto [min, max] = std::minmax(angles.x(), angles.y());
  const double angle = std::atan2(from_middle.y(), from_middle.x());
  return angle + whole_turn * std::ceil((min - angle) / whole_turn) <= max;
}

}  // namespace

std::vector<Chain> rims_of(const Shape& shape) {
  return std::visit([](const auto& kind) { return chains_of(kind); }, shape);
}

std::vector<Segment> parts_between(const Segment& segment, const Vec2& middle, const Vec2& angles) {
  std::vector<double> places{0.0, 1.0};
  add_crossing_of_ray(segment, middle, angles.x(), places);
  add_crossing_of_ray(segment, middle, angles.y(), places);
  std::ranges::sort(places);
  const auto at = [&](double place) {
    return Vec2(segment.from + place * (segment.to - segment.from));
  };
  std::vector<Segment> parts;
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    if (lies_between(at(0.5 * (places[k] + places[k + 1])) - middle, angles))
      parts.push_back({at(places[k]), at(places[k + 1])});
  return parts;
}

}  // namespace hackle
