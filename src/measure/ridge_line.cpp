// SPDX-License-Identifier: MIT
#include "measure/ridge_line.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "scene/geometry.hpp"

namespace hackle {
namespace {

constexpr double background = 0.2;    // damage that does not count
constexpr double half_breadth = 0.5;  // horizons, on each side
constexpr double damage_at_tip = 0.25;

// Means over up to `half` points on both sides; as many on each, so that ends stay.
Points smoothed(const Points& points, int half) {
  const int count = static_cast<int>(points.size());
  Points means(points.size());
  for (int k = 0; k < count; ++k) {
    const int reach = std::min({half, k, count - 1 - k});
    Vec2 sum(0, 0);
    for (int l = k - reach; l <= k + reach; ++l) sum += points[static_cast<std::size_t>(l)];
    means[static_cast<std::size_t>(k)] = sum / (2 * reach + 1);
  }
  return means;
}

class Ridge {
 public:
  explicit Ridge(const CrackGrowth& growth)
      : growth_(&growth),
        half_width_(std::max(1.5, half_breadth * growth.m())),
        half_length_(std::max(1.0, 0.25 * growth.m())) {}

  Points once(const Points& points, int half) const {
    const int count = static_cast<int>(points.size());
    Points moved = points;
    for (int k = 0; k < count; ++k) {
      const Vec2& from = points[static_cast<std::size_t>(std::max(0, k - half))];
      const Vec2& to = points[static_cast<std::size_t>(std::min(count - 1, k + half))];
      const Vec2 chord = to - from;
      if (!(chord.norm() > 0.0)) continue;
      const Vec2 along = chord.normalized(), across(-along.y(), along.x());
      Vec2& point = moved[static_cast<std::size_t>(k)];
      point += offset(point, along, across) * across;
    }
    return moved;
  }

 private:
  // Returns how far the centroid of damage lies to the side of a point.
  double offset(const Vec2& point, const Vec2& along, const Vec2& across) const {
    const Grid& grid = growth_->grid();
    const Vec2 corner = point + 0.5 * Vec2(grid.nx - 1, grid.ny - 1);
    const double reach = std::hypot(half_width_, half_length_);
    const Vec2 min = corner - Vec2(reach, reach), max = corner + Vec2(reach, reach);
    double sum = 0.0, weights = 0.0;
    for (int j = std::max(0, static_cast<int>(std::ceil(min.y()))); j <= max.y() && j < grid.ny;
         ++j)
      for (int i = std::max(0, static_cast<int>(std::ceil(min.x()))); i <= max.x() && i < grid.nx;
           ++i) {
        const Vec2 way = grid.from_centre(i, j) - point;
        const double side = way.dot(across);
        if (std::abs(side) > half_width_ || std::abs(way.dot(along)) > half_length_) continue;
        const double weight = std::max(growth_->damage(i, j) - background, 0.0);
        sum += weight * side;
        weights += weight;
      }
    return weights > 0.0 ? sum / weights : 0.0;
  }

  const CrackGrowth* growth_;
  double half_width_, half_length_;
};

// Damage between nodes; beyond the rim it is that of the rim.
double damage_between(const CrackGrowth& growth, const Vec2& place) {
  const Grid& grid = growth.grid();
  const auto inside = [](double x, int count) { return std::clamp(x, 0.0, count - 1.0); };
  const double x = inside(place.x() + 0.5 * (grid.nx - 1), grid.nx);
  const double y = inside(place.y() + 0.5 * (grid.ny - 1), grid.ny);
  const int i = std::min(static_cast<int>(x), grid.nx - 2),
            j = std::min(static_cast<int>(y), grid.ny - 2);
  const double a = x - i, b = y - j;
  return (1.0 - b) * ((1.0 - a) * growth.damage(i, j) + a * growth.damage(i + 1, j)) +
         b * ((1.0 - a) * growth.damage(i, j + 1) + a * growth.damage(i + 1, j + 1));
}

// The mean over a spacing across, for a crack may run along a row of nodes or between two.
double damage_on_line(const CrackGrowth& growth, const Vec2& place, const Vec2& across) {
  return (damage_between(growth, place - 0.5 * across) + damage_between(growth, place) +
          damage_between(growth, place + 0.5 * across)) /
         3.0;
}

bool on_plate(const CrackGrowth& growth, const Vec2& place) {
  const Grid& grid = growth.grid();
  return growth.holds(static_cast<int>(std::floor(place.x() + 0.5 * grid.nx)),
                      static_cast<int>(std::floor(place.y() + 0.5 * grid.ny)));
}

}  // namespace

Points ridge_line(const CrackGrowth& growth, const Points& path) {
  const int half = std::max(2, static_cast<int>(std::lround(0.5 * growth.m())));
  const Ridge ridge(growth);
  Points points = smoothed(path, half);
  points.front() = path.front();
  for (int pass = 0; pass < 4; ++pass)
    points = smoothed(ridge.once(points, half), std::max(1, half / 2));
  return points;
}

LineEnd end_of_line(const CrackGrowth& growth, const Vec2& from, const Vec2& direction,
                    double max) {
  constexpr double pace = 0.125;  // dx
  const Vec2 across(-direction.y(), direction.x());
  double before = damage_on_line(growth, from, across);
  for (double way = pace; way <= max; way += pace) {
    const Vec2 place = from + way * direction;
    if (!on_plate(growth, place)) return {place - 0.5 * pace * direction, true};
    const double here = damage_on_line(growth, place, across);
    if (before >= damage_at_tip && here < damage_at_tip)
      return {place - pace * (damage_at_tip - here) / (before - here) * direction, false};
    before = here;
  }
  return {from, false};
}

std::optional<FittedLine> fit(const Points& points) {
  if (points.size() < 3) return std::nullopt;
  Vec2 mean(0, 0);
  for (const Vec2& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec2& point : points) spread += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  Vec2 direction = axes.eigenvectors().col(1);
  if (direction.dot(points.back() - points.front()) < 0.0) direction = -direction;
  return FittedLine{mean, direction};
}

std::optional<Vec2> meeting_of(const FittedLine& one, const FittedLine& other) {
  const double slant = cross(one.direction, other.direction);
  if (std::abs(slant) < 0.05) return std::nullopt;
  return one.point + cross(other.point - one.point, other.direction) / slant * one.direction;
}

std::vector<double> ways_along(const Points& points) {
  std::vector<double> ways(points.size());
  for (std::size_t k = 1; k < points.size(); ++k)
    ways[k] = ways[k - 1] + (points[k] - points[k - 1]).norm();
  return ways;
}

}  // namespace hackle
