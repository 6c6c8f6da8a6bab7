// SPDX-License-Identifier: MIT
#include "lattice/rim_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "lattice/carve.hpp"
#include "scene/rim.hpp"

namespace hackle {
namespace {

// All lengths are in spacings, places relative to the centre of the lattice.
constexpr double probe = 0.01;  // how far from a rim the material beside it is looked for
constexpr double same_rim = 1e-4;
constexpr double longest_part = 0.125;
constexpr int nearby = 3;  // nodes farther from their part of a rim, along an axis, have none of it

// The void of a plate, to tell on which side of a rim its material is.
class Solid {
 public:
  Solid(const Plate& plate, const Grid& grid)
      : half_(0.5 / grid.dx * Vec2(plate.width, plate.height)) {
    const double factor = 1.0 / grid.dx;
    for (const Cutout& cutout : plate.cutouts) {
      voids_.push_back(transformed(cutout.shape, grid.centre, factor));
      boxes_.push_back(bounds(voids_.back()));
    }
    for (const Outline& outline : plate.outlines)
      outlines_.push_back(transformed(outline, grid.centre, factor));
  }

  bool is_at(const Vec2& point) const {
    if ((point.cwiseAbs() - half_).maxCoeff() > 0.0) return false;
    for (std::size_t k = 0; k < voids_.size(); ++k)
      if ((point - boxes_[k].min).minCoeff() >= 0.0 && (boxes_[k].max - point).minCoeff() >= 0.0 &&
          is_inside(voids_[k], point, 0.0))
        return false;
    return std::ranges::all_of(outlines_,
                               [&](const Outline& outline) { return covers(outline, point, 0.0); });
  }

 private:
  Vec2 half_;
  std::vector<Shape> voids_;
  std::vector<Box> boxes_;
  std::vector<Outline> outlines_;
};

// Nodes that are equally near share a part of a rim, so that mirror images get the same.
struct Nearest {
  std::vector<std::pair<int, int>> nodes;
};

class RimCollector {
 public:
  RimCollector(const Plate& plate, const Lattice& lattice)
      : lattice_(lattice), solid_(plate, lattice.grid) {}

  // Adds the rims of a shape between angles that are seen from `middle`, without what they have in
  // common with shapes that were added before.
  void add(const Shape& shape, const Vec2& middle, const RimPart& angles) {
    for (const Chain& chain : rims_of(shape))
      for_each_between(chain, middle, angles, [&](const Segment& piece) { add_rim(piece); });
    added_.push_back(shape);
  }

  void add_crack(const Chain& chain, const Vec2& middle, const RimPart& angles) {
    for_each_between(chain, middle, angles, [&](const Segment& piece) {
      for_each_short(piece, [&](const Vec2& at, const Vec2& left, double length) {
        if (solid_.is_at(at + probe * left) && solid_.is_at(at - probe * left))
          add_faces(at, left, length);
      });
    });
  }

  std::vector<RimShare> shares() {
    std::vector<RimShare> list;
    for (auto& [index, share] : shares_) {
      share.middle = lattice_.grid.centre + lattice_.grid.dx / share.length * share.middle;
      share.length = rounded(share.length);
      share.normal = {rounded(share.normal.x()), rounded(share.normal.y())};
      list.push_back(share);
    }
    return list;
  }

 private:
  // Sums of mirror images differ by their last bits, which this takes away.
  static double rounded(double value) { return std::round(value * 0x1p32) * 0x1p-32; }

  // A rim has material on one side.
  void add_rim(const Segment& piece) {
    for_each_short(piece, [&](const Vec2& at, const Vec2& left, double length) {
      const bool here = solid_.is_at(at + probe * left);
      if (here == solid_.is_at(at - probe * left) || was_added(at)) return;
      const Vec2 normal = here ? left : Vec2(-left);
      add_share(nearest(at, normal, -tie), at, normal, length);
    });
  }

  bool was_added(const Vec2& at) const {
    return std::ranges::any_of(added_, [&](const Shape& shape) {
      return covers(shape, at, same_rim) && !is_inside(shape, at, same_rim);
    });
  }

  // Cuts a piece where cells meet, and further into short parts; calls visit(middle, normal to the
  // left, length) for each.
  template <class Visit>
  void for_each_short(const Segment& piece, const Visit& visit) const {
    const Vec2 along = piece.to - piece.from;
    if (!(along.norm() > 0.0)) return;
    const Vec2 left = Vec2(-along.y(), along.x()) / along.norm();
    const std::vector<double> places = places_on(piece);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const double length = (places[k + 1] - places[k]) * along.norm();
      if (length < tie) continue;
      const int count = std::max(1, static_cast<int>(std::ceil(length / longest_part - tie)));
      for (int part = 0; part < count; ++part) {
        const double place = places[k] + (places[k + 1] - places[k]) * (part + 0.5) / count;
        visit(Vec2(piece.from + place * along), left, length / count);
      }
    }
  }

  std::vector<double> places_on(const Segment& piece) const {
    std::vector<double> places{0.0, 1.0};
    const std::array nodes{lattice_.grid.nx, lattice_.grid.ny};
    for (int axis = 0; axis < 2; ++axis) {
      const double from = piece.from[axis], to = piece.to[axis];
      const double middle = 0.5 * nodes[static_cast<std::size_t>(axis)];
      const double last = std::min(std::max(from, to), middle);
      for (double line = std::ceil(std::max(std::min(from, to), -middle) + middle) - middle;
           line <= last; line += 1.0)
        if ((line - from) * (line - to) < 0.0) places.push_back((line - from) / (to - from));
    }
    std::ranges::sort(places);
    return places;
  }

  bool may_bear(int i, int j) const {
    const Grid& grid = lattice_.grid;
    return grid.contains(i, j) && !lattice_.is_void(i, j) &&
           lattice_.initial_neighbours[grid.index(i, j)] > 0;
  }

  // Returns the nodes of the material on the side of `normal` that are nearest to a point.
  Nearest nearest(const Vec2& point, const Vec2& normal, double beyond) const {
    const Grid& grid = lattice_.grid;
    const int column = static_cast<int>(std::floor(point.x() + 0.5 * grid.nx));
    const int row = static_cast<int>(std::floor(point.y() + 0.5 * grid.ny));
    Nearest found;
    double min = nearby;
    for (int j = row - nearby; j <= row + nearby; ++j)
      for (int i = column - nearby; i <= column + nearby; ++i) {
        if (!may_bear(i, j)) continue;
        const Vec2 apart = grid.from_centre(i, j) - point;
        if (apart.dot(normal) <= beyond || apart.norm() > min + tie) continue;
        if (apart.norm() < min - tie) found.nodes.clear();
        min = std::min(min, apart.norm());
        found.nodes.emplace_back(i, j);
      }
    return found;
  }

  void add_faces(const Vec2& middle, const Vec2& left, double length) {
    const Nearest here = nearest(middle, left, tie), there = nearest(middle, -left, tie);
    if (here.nodes.empty() || there.nodes.empty()) return;
    add_share(here, middle, left, length);
    add_share(there, middle, -left, length);
  }

  void add_share(const Nearest& nearest, const Vec2& middle, const Vec2& normal, double length) {
    for (const auto& [i, j] : nearest.nodes) {
      const double part = length / static_cast<double>(nearest.nodes.size());
      RimShare& share = shares_[lattice_.grid.index(i, j)];
      share.i = i;
      share.j = j;
      share.length += part;
      share.normal += part * normal;
      share.middle += part * middle;
    }
  }

  const Lattice& lattice_;
  Solid solid_;
  std::vector<Shape> added_;
  std::map<std::size_t, RimShare> shares_;  // by Grid::index
};

Vec2 middle_of(const Box& box) {
  return 0.5 * (box.min + box.max);
}

}  // namespace

std::vector<RimShare> shares_of_rims(const Plate& plate, const Lattice& lattice,
                                     const std::string& rim, const RimPart& angles) {
  const Vec2& origin = lattice.grid.centre;
  const double factor = 1.0 / lattice.grid.dx;
  RimCollector collector(plate, lattice);
  const auto add = [&](const Shape& shape, const Vec2& middle) {
    collector.add(transformed(shape, origin, factor), factor * (middle - origin), angles);
  };
  for (const Cutout& cutout : plate.cutouts)
    if (cutout.name == rim) add(cutout.shape, middle_of(bounds(cutout.shape)));
  for (const Outline& outline : plate.outlines)
    if (outline.name == rim)
      for (const Shape& area : outline.areas) add(area, middle_of(bounds(outline)));
  return collector.shares();
}

std::vector<RimShare> shares_of_cracks(const Plate& plate, const Lattice& lattice,
                                       const std::string& name, const RimPart& angles) {
  RimCollector collector(plate, lattice);
  for (const Crack& crack : plate.cracks) {
    if (crack.name != name) continue;
    Chain chain;
    for (const Vec2& point : crack.points) chain.push_back(lattice.grid.from_centre(point));
    Box box{chain.front(), chain.front()};
    for (const Vec2& point : chain) box = {box.min.cwiseMin(point), box.max.cwiseMax(point)};
    collector.add_crack(chain, middle_of(box), angles);
  }
  return collector.shares();
}

}  // namespace hackle
