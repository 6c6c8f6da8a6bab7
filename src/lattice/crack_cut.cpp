// SPDX-License-Identifier: MIT
#include "lattice/crack_cut.hpp"

#include <algorithm>
#include <cmath>

namespace hackle {
namespace {

constexpr double tie = 1e-9;  // in units of dx

struct Segment {
  Vec2 from, to;
};

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// On which side of the line through `segment` a point lies: -1, 0 (on it) or 1.
// Measured from the middle of the segment, so that exchanging its ends flips the sign exactly.
int side(const Segment& segment, const Vec2& point) {
  const Vec2 along = segment.to - segment.from;
  const double distance = cross(along, point - 0.5 * (segment.from + segment.to)) / along.norm();
  return std::abs(distance) <= tie ? 0 : (distance > 0.0 ? 1 : -1);
}

// Two segments on one line: do their ranges along it overlap?
bool overlap_on_line(const Segment& one, const Segment& other) {
  const Vec2 along = (one.to - one.from).normalized();
  const auto at = [&](const Vec2& point) { return along.dot(point - one.from); };
  const auto [least, most] = std::minmax({at(other.from), at(other.to)});
  return most > tie && least < at(one.to) - tie;
}

bool crosses(const Segment& crack, const Segment& bond) {
  const int from = side(crack, bond.from), to = side(crack, bond.to);
  if (from * to > 0) return false;
  if (from == 0 && to == 0) return overlap_on_line(crack, bond);
  return side(bond, crack.from) * side(bond, crack.to) < 0;
}

struct Range {
  int first, last;
};

// The columns (or rows) of a lattice of n nodes that have bonds near the crack.
Range near(double one, double other, int n, int reach) {
  const double middle = 0.5 * (n - 1);
  const auto [least, most] = std::minmax({one, other});
  return {std::max(0, static_cast<int>(std::floor(least + middle)) - reach),
          std::min(n - 1, static_cast<int>(std::ceil(most + middle)) + reach)};
}

}  // namespace

void cut(const Crack& crack, const Grid& grid, const Family& family, BondBits& bonds) {
  const Segment segment{grid.from_centre(crack.from), grid.from_centre(crack.to)};
  const Range columns = near(segment.from.x(), segment.to.x(), grid.nx, family.reach());
  const Range rows = near(segment.from.y(), segment.to.y(), grid.ny, family.reach());
  for (int j = rows.first; j <= rows.last; ++j)
    for (int i = columns.first; i <= columns.last; ++i)
      family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
        const Segment bond{grid.from_centre(i, j), grid.from_centre(i + a, j + b)};
        if (crosses(segment, bond)) bonds.clear(grid.layout().at(i, j), bit);
      });
}

}  // namespace hackle
