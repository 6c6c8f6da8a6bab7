// SPDX-License-Identifier: MIT
#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hackle {
namespace {

// For two segments on one line: returns whether their ranges along it overlap.
bool overlap_on_line(const Segment& one, const Segment& other, double tie) {
  const Vec2 along = (one.to - one.from).normalized();
  const auto at = [&](const Vec2& point) { return along.dot(point - one.from); };
  const auto [min, max] = std::minmax({at(other.from), at(other.to)});
  return max > tie && min < at(one.to) - tie;
}

// If an end lies within rounding of the other segment, the distances of the ends decide instead:
// two collinear segments with a gap between them must not seem to cross.
bool cross_properly(const Segment& one, const Segment& other) {
  const double size = std::max({one.from.cwiseAbs().maxCoeff(), one.to.cwiseAbs().maxCoeff(),
                                other.from.cwiseAbs().maxCoeff(), other.to.cwiseAbs().maxCoeff()});
  const double noise = 1e-14 * size;
  return side(one, other.from, noise) * side(one, other.to, noise) < 0 &&
         side(other, one.from, noise) * side(other, one.to, noise) < 0;
}

bool is_point(const Segment& segment) {
  return segment.from == segment.to;
}

}  // namespace

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

int side(const Segment& segment, const Vec2& point, double tie) {
  const Vec2 along = segment.to - segment.from;
  // Measured from the midpoint, so that exchanging the ends flips the sign exactly.
  const double distance = cross(along, point - 0.5 * (segment.from + segment.to)) / along.norm();
  return std::abs(distance) <= tie ? 0 : (distance > 0.0 ? 1 : -1);
}

double distance(const Segment& segment, const Vec2& point) {
  const Vec2 middle = 0.5 * (segment.from + segment.to), half = 0.5 * (segment.to - segment.from);
  const double length2 = half.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(half.dot(point - middle) / length2, -1.0, 1.0) : 0.0;
  return (point - middle - t * half).norm();
}

double distance(const Segment& one, const Segment& other) {
  if (!is_point(one) && !is_point(other) && cross_properly(one, other)) return 0.0;
  return std::min({distance(one, other.from), distance(one, other.to), distance(other, one.from),
                   distance(other, one.to)});
}

bool crosses(const Segment& one, const Segment& other, double tie) {
  const int from = side(one, other.from, tie), to = side(one, other.to, tie);
  if (from * to > 0) return false;
  if (from == 0 && to == 0) return overlap_on_line(one, other, tie);
  return side(other, one.from, tie) * side(other, one.to, tie) < 0;
}

std::vector<Vec2> arc(const Vec2& centre, double radius, double from, double to) {
  constexpr double widest = 2.8e-3;  // largest angle of a chord, rad: 1 - cos(widest / 2) < 1e-6
  const double turn = to - from;
  const auto pieces = static_cast<int>(std::max(2.0, std::ceil(std::abs(turn) / widest)));
  std::vector<Vec2> points;
  for (int k = 0; k <= pieces; ++k) {
    const double angle = from + turn * (static_cast<double>(k) / pieces);
    points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  if (std::abs(turn) > 2.0 * std::numbers::pi - 1e-9) points.back() = points.front();
  return points;
}

}  // namespace hackle
