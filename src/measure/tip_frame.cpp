// SPDX-License-Identifier: MIT
#include "measure/tip_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "measure/cracks.hpp"
#include "measure/gaps.hpp"

namespace hackle {
namespace {

constexpr double horizons_of_direction = 3.0;
constexpr float open_gap = 0.2F;  // half of that beside a straight cut

Vec2 snapped_to_axis(const Vec2& direction) {
  const double within = std::sin(2.0 * std::numbers::pi / 180.0);
  if (std::abs(direction.y()) < within) return {std::copysign(1.0, direction.x()), 0.0};
  if (std::abs(direction.x()) < within) return {0.0, std::copysign(1.0, direction.y())};
  return direction;
}

std::optional<Vec2> away_from_gaps(const std::vector<float>& gaps, const Grid& grid, double m,
                                   const Vec2& tip) {
  const Vec2 middle = grid.from_centre(tip);
  Vec2 sum(0, 0);
  double count = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 arm = grid.from_centre(i, j) - middle;
      if (gaps[grid.index(i, j)] <= open_gap || arm.norm() > horizons_of_direction * m) continue;
      sum += arm;
      count += 1.0;
    }
  // Gaps on all sides tell no direction.
  if (count == 0.0 || sum.norm() < 0.1 * count * m) return std::nullopt;
  return snapped_to_axis(-sum.normalized());
}

// The gap beside a line at a place on it, dx from the centre: the mean of nodes on its two sides.
class GapsBesideLine {
 public:
  GapsBesideLine(const std::vector<float>& gaps, const Grid& grid, const Vec2& normal)
      : gaps_(&gaps), grid_(&grid), aside_(0.5 * normal) {}

  double at(const Vec2& place) const {
    return 0.5 * (between_nodes(place + aside_) + between_nodes(place - aside_));
  }

 private:
  double of_node(double column, double row) const {
    const int i = std::clamp(static_cast<int>(column), 0, grid_->nx - 1);
    const int j = std::clamp(static_cast<int>(row), 0, grid_->ny - 1);
    return gaps_->at(grid_->index(i, j));
  }
  double between_nodes(const Vec2& place) const {
    const double x = place.x() + 0.5 * (grid_->nx - 1), y = place.y() + 0.5 * (grid_->ny - 1);
    const double i = std::floor(x), j = std::floor(y);
    const double s = x - i, t = y - j;
    return (1 - t) * ((1 - s) * of_node(i, j) + s * of_node(i + 1, j)) +
           t * ((1 - s) * of_node(i, j + 1) + s * of_node(i + 1, j + 1));
  }

  const std::vector<float>* gaps_;
  const Grid* grid_;
  Vec2 aside_;
};

// Returns how far ahead of a place, dx, the gap falls to half of that a horizon behind.
double end_of_cut(const GapsBesideLine& gaps, const Vec2& place, const Vec2& ahead, double m) {
  const double half = 0.5 * gaps.at(place - m * ahead);
  constexpr double stride = 0.25;
  double before = gaps.at(place - m * ahead);
  for (double t = -m + stride; t <= m; t += stride) {
    const double now = gaps.at(place + t * ahead);
    if (now < half) return t - stride * (half - now) / std::max(before - now, 1e-12);
    before = now;
  }
  return 0.0;
}

}  // namespace

std::optional<Vec2> direction_at(const View& view, const Vec2& tip) {
  const Lattice& lattice = view.lattice();
  return away_from_gaps(gaps(view), lattice.grid, lattice.family.m(), tip);
}

std::optional<TipFrame> foremost_tip(const View& view, const Vec2& along) {
  const Grid& grid = view.lattice().grid;
  const double m = view.lattice().family.m();
  const Field field{"damage", "", 1, gaps(view)};
  const std::optional<Vec2> foremost_node = foremost(field, grid, along.stableNormalized());
  if (!foremost_node) return std::nullopt;
  TipFrame frame{*foremost_node, along.stableNormalized()};
  if (const auto ahead = away_from_gaps(field.values, grid, m, frame.tip)) frame.ahead = *ahead;
  const GapsBesideLine beside(field.values, grid, frame.normal());
  frame.tip +=
      grid.dx * end_of_cut(beside, grid.from_centre(frame.tip), frame.ahead, m) * frame.ahead;
  return frame;
}

}  // namespace hackle
