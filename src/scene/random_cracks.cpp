// SPDX-License-Identifier: MIT
#include "scene/random_cracks.hpp"

#include <cmath>
#include <random>

#include <fmt/format.h>

#include "base/interrupt.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

constexpr int max_tries = 10000;  // per crack

// Draws uniformly: the distributions of the standard library differ between libraries.
double between(const Vec2& range, std::mt19937_64& random) {
  const double share = static_cast<double>(random() >> 11) * 0x1p-53;
  return range.x() + share * (range.y() - range.x());
}

// Returns (cos, sin); those of the C library differ in their last bits between machines.
Vec2 direction(double angle) {
  constexpr double quarter = 0.5 * std::numbers::pi;
  const double turns = std::floor(angle / quarter + 0.5), x = angle - turns * quarter;
  double c = 0.0, s = 0.0, term = 1.0;
  for (int n = 1; n <= 20; ++n) {
    (n % 2 == 1 ? c : s) += term;
    term *= (n % 2 == 1 ? x : -x) / n;
  }
  switch (static_cast<int>(std::fmod(turns, 4.0) + 4.0) % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

Crack draw(const RandomCracks& cracks, std::mt19937_64& random) {
  throw_if_interrupted();
  for (int trial = 0; trial < max_tries; ++trial) {
    const double length = between(cracks.length, random);
    const Vec2 half = 0.5 * length * direction(between(cracks.angle, random));
    const Vec2 min = cracks.area.min + half.cwiseAbs();
    const Vec2 max = cracks.area.max - half.cwiseAbs();
    const double x = between({min.x(), max.x()}, random);
    const double y = between({min.y(), max.y()}, random);
    if ((max - min).minCoeff() < 0.0) continue;
    return {Vec2(x, y) - half, Vec2(x, y) + half, cracks.born};
  }
  throw Error(ErrorKind::refused,
              fmt::format("random_cracks: cracks of {} to {} do not fit into the area",
                          quantity(cracks.length.x(), "m"), quantity(cracks.length.y(), "m")),
              "make them shorter, or the area larger");
}

}  // namespace

std::vector<Crack> make(const RandomCracks& cracks) {
  std::mt19937_64 random(static_cast<std::uint64_t>(cracks.seed));
  std::vector<Crack> list;
  list.reserve(static_cast<std::size_t>(cracks.count));
  for (int k = 0; k < cracks.count; ++k) list.push_back(draw(cracks, random));
  return list;
}

void check(const Plate& plate, const RandomCracks& cracks, Problems& problems) {
  if (cracks.length.x() > cracks.length.y())
    problems.add("random_cracks: the least length is above the most", "length = {least, most}");
  if (cracks.angle.x() > cracks.angle.y())
    problems.add("random_cracks: the least angle is above the most", "angle = {least, most}");
  const double slack = 1e-9 * (plate.width + plate.height);
  const bool has_area = (cracks.area.max - cracks.area.min).minCoeff() > 0.0;
  const bool on_plate = cracks.area.min.minCoeff() >= -slack &&
                        cracks.area.max.x() <= plate.width + slack &&
                        cracks.area.max.y() <= plate.height + slack;
  if (!has_area)
    problems.add("random_cracks: the area is empty",
                 "from is its lower left corner, to its "
                 "upper right one");
  else if (!on_plate)
    problems.add("random_cracks: the area reaches beyond the plate",
                 fmt::format("the plate is {} x {}", quantity(plate.width, "m"),
                             quantity(plate.height, "m")));
}

}  // namespace hackle
