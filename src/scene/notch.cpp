// SPDX-License-Identifier: MIT
#include "scene/notch.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "scene/geometry.hpp"

namespace hackle {
namespace {

constexpr double steepest = 1.5;  // rad, largest angle of a side from the perpendicular

// Distances from the left, right, lower and upper edge.
std::array<double, 4> distances(const Plate& plate, const Vec2& at) {
  return {std::abs(at.x()), std::abs(at.x() - plate.width), std::abs(at.y()),
          std::abs(at.y() - plate.height)};
}

double slack(const Plate& plate) {
  return 1e-9 * (plate.width + plate.height);
}

// Returns the direction into the plate from the edge (or the two edges) nearest to the point.
Vec2 inwards(const Plate& plate, const Vec2& at) {
  const std::array<Vec2, 4> normals{Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)};
  const std::array<double, 4> away = distances(plate, at);
  const double nearest = *std::ranges::min_element(away);
  Vec2 sum{0, 0};
  for (std::size_t k = 0; k < away.size(); ++k)
    if (away[k] <= nearest + slack(plate)) sum += normals[k];
  return sum == Vec2(0, 0) ? Vec2(1, 0) : Vec2(sum.normalized());
}

Vec2 turned(const Vec2& vector, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

// Returns half the angle between the two sides.
double half_opening(const Notch& notch) {
  return notch.kind == Notch::Kind::v ? std::atan(0.5 * notch.width / notch.depth) : 0.0;
}

// Extends a side beyond its mouth to `margin` outside the edge.
Vec2 continued(const Vec2& from, const Vec2& towards, const Vec2& at, const Vec2& inward,
               double margin) {
  const Vec2 along = (towards - from).normalized();
  const double inside = inward.dot(towards - at);
  return towards + along * ((inside + margin) / -inward.dot(along));
}

}  // namespace

Shape shape_of(const Notch& notch, const Plate& plate) {
  const Vec2 inward = inwards(plate, notch.at), along = turned(inward, notch.angle);
  const Vec2 half = 0.5 * notch.width * Vec2(-along.y(), along.x());
  const Vec2 tip = notch.at + notch.depth * along;
  if (notch.kind == Notch::Kind::u) {
    const double back = notch.width * (1.0 + std::abs(std::tan(notch.angle)));
    return Capsule{{notch.at - back * along, tip - 0.5 * notch.width * along}, 0.5 * notch.width};
  }
  const bool sharp = notch.kind == Notch::Kind::v;
  const Vec2 left = sharp ? tip : Vec2(tip + half), right = sharp ? tip : Vec2(tip - half);
  const auto out = [&](const Vec2& end, const Vec2& mouth) {
    return continued(end, mouth, notch.at, inward, notch.width);
  };
  Polygon polygon{{left, out(left, notch.at + half), out(right, notch.at - half)}};
  if (!sharp) polygon.points.push_back(right);
  return polygon;
}

void check(const Plate& plate, const Notch& notch, Problems& problems) {
  const std::array<double, 4> away = distances(plate, notch.at);
  const double nearest = *std::ranges::min_element(away);
  const bool on_plate = notch.at.x() >= -slack(plate) && notch.at.y() >= -slack(plate) &&
                        notch.at.x() <= plate.width + slack(plate) &&
                        notch.at.y() <= plate.height + slack(plate);
  if (!on_plate)
    problems.add(fmt::format("notch: at ({}, {}) lies outside the plate",
                             quantity(notch.at.x(), "m"), quantity(notch.at.y(), "m")),
                 "give a point on an edge");
  else if (nearest > slack(plate))
    problems.add(
        fmt::format("notch: at ({}, {}) lies {} inside the plate", quantity(notch.at.x(), "m"),
                    quantity(notch.at.y(), "m"), quantity(nearest, "m")),
        "a notch begins on an edge; p:hole { from, to, width } is a slot anywhere");
  if (!(std::abs(notch.angle) + half_opening(notch) <= steepest))
    problems.add("notch: it is so oblique or so wide that a side of it never leaves the plate",
                 "take a smaller angle, a smaller width or a larger depth");
}

}  // namespace hackle
