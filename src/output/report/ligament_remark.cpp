// SPDX-License-Identifier: MIT
#include "output/report/ligament_remark.hpp"

#include <algorithm>
#include <limits>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

// What a bar lacks of its stiffness is this over its width in horizons: 0.19 with `full` at 3
// spacings, 0.21 and 0.24 at 4 with `full` and `area` (src/lattice/README.md 3.10).
constexpr double softening = 0.2;

Box box_of(const Plate& plate) {
  return {Vec2(0, 0), Vec2(plate.width, plate.height)};
}

double thickness(const Shape& area, const Plate& plate) {
  if (const auto* ring = std::get_if<Ring>(&area)) return ring->outer - ring->inner;
  const Box box = bounds(area), all = box_of(plate);
  return (box.max.cwiseMin(all.max) - box.min.cwiseMax(all.min)).minCoeff();
}

// The gap between two boxes along an axis, where they face each other; else none.
void face(const Box& one, const Box& other, int axis, double& min) {
  const int across = 1 - axis;
  if (one.max[across] <= other.min[across] || other.max[across] <= one.min[across]) return;
  const double gap = std::max(one.min[axis] - other.max[axis], other.min[axis] - one.max[axis]);
  if (gap > 0.0) min = std::min(min, gap);
}

void keep_from_edges(const Box& cutout, const Box& all, double& min) {
  for (const Vec2& gap : {Vec2(cutout.min - all.min), Vec2(all.max - cutout.max)})
    for (const double width : gap)
      if (width > 0.0) min = std::min(min, width);
}

double length_of(const Crack& crack) {
  double sum = 0.0;
  for (std::size_t k = 1; k < crack.points.size(); ++k)
    sum += (crack.points[k] - crack.points[k - 1]).norm();
  return sum;
}

// Returns the way from a tip to the edge of the plate; 0 from outside.
double way_ahead(const Vec2& from, const Vec2& tip, const Box& all) {
  const Vec2 along = (tip - from).normalized();
  double way = std::numeric_limits<double>::infinity();
  for (const int axis : {0, 1}) {
    if (along[axis] == 0.0) continue;
    const double edge = along[axis] > 0.0 ? all.max[axis] : all.min[axis];
    way = std::min(way, (edge - tip[axis]) / along[axis]);
  }
  return way;
}

// A short crack near an edge leaves no ligament: the plate is whole beside it.
void keep_ahead(const Crack& crack, const Box& all, double& min) {
  const std::vector<Vec2>& points = crack.points;
  if (points.size() < 2) return;
  const double length = length_of(crack);
  for (const double way : {way_ahead(points[1], points[0], all),
                           way_ahead(points[points.size() - 2], points.back(), all)})
    if (way > 1e-9 * length && way < length) min = std::min(min, way);
}

}  // namespace

double narrowest(const Plate& plate) {
  double min = std::min(plate.width, plate.height);
  for (const Outline& outline : plate.outlines)
    for (const Shape& area : outline.areas) min = std::min(min, thickness(area, plate));
  std::vector<Box> boxes;
  for (const Cutout& cutout : plate.cutouts) {
    const Box box = bounds(cutout.shape);
    keep_from_edges(box, box_of(plate), min);
    for (const Box& other : boxes)
      for (const int axis : {0, 1}) face(box, other, axis, min);
    boxes.push_back(box);
  }
  for (const Crack& crack : plate.cracks) keep_ahead(crack, box_of(plate), min);
  return std::max(min, 0.0);
}

std::optional<std::string> ligament_remark(const Simulation& simulation) {
  if (simulation.numerics().surface != Surface::none) return std::nullopt;
  const double width = narrowest(simulation.plate());
  const double horizons = width / simulation.numerics().horizon_or_default();
  if (horizons >= min_ligament * (1.0 - 1e-9)) return std::nullopt;
  return fmt::format(
      "the narrowest part is {}, {:.2g} horizons wide: its surfaces make it softer, by about "
      "{:.0f} "
      "% in tension; surface = \"energy\" corrects it",
      quantity(width, "m"), horizons, std::min(50.0, 100.0 * softening / std::max(horizons, 0.1)));
}

}  // namespace hackle
