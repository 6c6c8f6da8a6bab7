// SPDX-License-Identifier: MIT
#include "output/report/ligament_remark.hpp"

#include <algorithm>
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
  return (box.most.cwiseMin(all.most) - box.least.cwiseMax(all.least)).minCoeff();
}

// The gap between two boxes along an axis, where they face each other; else none.
void face(const Box& one, const Box& other, int axis, double& least) {
  const int across = 1 - axis;
  if (one.most[across] <= other.least[across] || other.most[across] <= one.least[across]) return;
  const double gap =
      std::max(one.least[axis] - other.most[axis], other.least[axis] - one.most[axis]);
  if (gap > 0.0) least = std::min(least, gap);
}

void keep_from_edges(const Box& cutout, const Box& all, double& least) {
  for (const Vec2& gap : {Vec2(cutout.least - all.least), Vec2(all.most - cutout.most)})
    for (const double width : gap)
      if (width > 0.0) least = std::min(least, width);
}

}  // namespace

double narrowest(const Plate& plate) {
  double least = std::min(plate.width, plate.height);
  for (const Outline& outline : plate.outlines)
    for (const Shape& area : outline.areas) least = std::min(least, thickness(area, plate));
  std::vector<Box> boxes;
  for (const Cutout& cutout : plate.cutouts) {
    const Box box = bounds(cutout.shape);
    keep_from_edges(box, box_of(plate), least);
    for (const Box& other : boxes)
      for (const int axis : {0, 1}) face(box, other, axis, least);
    boxes.push_back(box);
  }
  return std::max(least, 0.0);
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
