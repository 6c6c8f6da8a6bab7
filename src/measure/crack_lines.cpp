// SPDX-License-Identifier: MIT
#include "measure/crack_lines.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace hackle {
namespace {

constexpr double apart = 1.5;          // horizons, where branches do not draw each other together
constexpr double length_of_fit = 2.5;  // horizons of a branch
constexpr double least_fitted = 20.0;  // dx
constexpr double common_middle = 1.0;  // dx
constexpr double looked_at = 12.0;     // horizons from a fork
constexpr double tip_zone = 0.5;       // horizons before the end of a line that are not fitted

CrackLine line_of(const CrackGrowth& growth, const SkeletonPath& path) {
  const Grid& grid = growth.grid();
  const auto columns = static_cast<std::size_t>(grid.nx);
  CrackLine line;
  line.parent = path.parent;
  line.leaves = path.leaves;
  Points nodes;
  double latest = CrackGrowth::at_start;
  for (const std::size_t node : path.nodes) {
    nodes.push_back(
        grid.from_centre(static_cast<int>(node % columns), static_cast<int>(node / columns)));
    latest = std::max(latest, growth.arrival(node));
    line.times.push_back(latest);
  }
  while (line.grown < nodes.size() && line.times[line.grown] == CrackGrowth::at_start) ++line.grown;
  line.points = nodes.size() < 2 ? nodes : ridge_line(growth, nodes);
  line.ways = ways_along(line.points);
  return line;
}

double distance_to(const Points& points, std::size_t first, std::size_t last, const Vec2& place) {
  double min = (points[first] - place).norm();
  for (std::size_t k = first; k <= last; ++k) min = std::min(min, (points[k] - place).norm());
  return min;
}

// The first points of a line behind a fork.
struct Stretch {
  CrackLine* line = nullptr;
  std::size_t first = 0, last = 0;
  bool to_tip = false;
};

Stretch stretch_of(CrackLine& line, std::size_t first, std::size_t last, double m) {
  const bool whole = last == line.last();
  std::size_t end = first;
  while (end < last && line.ways[end] - line.ways[first] <= looked_at * m) ++end;
  return {&line, first, end, whole && end == last};
}

// Returns the first point from which on the stretch is apart from another.
std::size_t clean_from(const Stretch& one, const Stretch& other, double m) {
  std::size_t clean = one.last;
  while (clean > one.first && distance_to(other.line->points, other.first, other.last,
                                          one.line->points[clean - 1]) >= apart * m)
    --clean;
  return clean;
}

std::optional<FittedLine> middle_of(const Stretch& stretch, std::size_t clean, double m) {
  const auto& ways = stretch.line->ways;
  const double end = std::min(ways[clean] + std::max(length_of_fit * m, least_fitted),
                              ways[stretch.last] - (stretch.to_tip ? tip_zone * m : 0.0));
  Points points;
  for (std::size_t k = clean; k <= stretch.last && ways[k] <= end; ++k)
    points.push_back(stretch.line->points[k]);
  return fit(points);
}

// Puts the points between two others on a straight line.
void straighten(Points& points, std::size_t first, std::size_t last) {
  const Vec2 from = points[first], way = points[last] - points[first];
  for (std::size_t k = first + 1; k < last; ++k)
    points[k] = from + static_cast<double>(k - first) / static_cast<double>(last - first) * way;
}

class Maker {
 public:
  Maker(const CrackGrowth& growth, const CrackSkeleton& skeleton) : m_(growth.m()) {
    for (const SkeletonPath& path : skeleton.paths) made_.lines.push_back(line_of(growth, path));
    for (std::size_t number = 0; number < made_.lines.size(); ++number)
      part(static_cast<int>(number));
    for (CrackLine& line : made_.lines) settle_origin(line);
    first_pieces_.assign(made_.lines.size(), -1);
    for (std::size_t number = 0; number < made_.lines.size(); ++number)
      cut(static_cast<int>(number));
    for (std::size_t number = 0; number < made_.lines.size(); ++number)
      find_fork(static_cast<int>(number));
  }
  CrackLines take() { return std::move(made_); }

 private:
  CrackLine& line(int number) { return made_.lines[static_cast<std::size_t>(number)]; }

  // Paths may leave each other before their middles do. The first points of a line are rough.
  void part(int number) {
    CrackLine& branch = line(number);
    if (branch.parent < 0) return;
    const CrackLine& from = line(branch.parent);
    const std::size_t left = branch.leaves;
    std::size_t common = 0;
    for (std::size_t k = 0; k + 2 < branch.points.size(); ++k) {
      const std::size_t nearest = nearest_to(branch.points[k], from, branch.leaves);
      const bool same = (from.points[nearest] - branch.points[k]).norm() <= common_middle;
      if (!same && static_cast<double>(k - common) > std::max(m_, 4.0)) break;
      if (!same) continue;
      branch.leaves = nearest;
      common = k;
    }
    for (CrackLine& other : made_.lines)
      if (other.parent == number) hang_anew(other, branch, common, left);
    drop_first(branch, common);
  }

  // Returns the point of a line, from one on, that is the nearest to a place.
  static std::size_t nearest_to(const Vec2& place, const CrackLine& line, std::size_t first) {
    std::size_t nearest = first;
    for (std::size_t l = first; l < line.points.size(); ++l)
      if ((line.points[l] - place).norm() < (line.points[nearest] - place).norm()) nearest = l;
    return nearest;
  }

  // A line that hangs on one whose first points are about to go to that one's parent.
  void hang_anew(CrackLine& other, const CrackLine& branch, std::size_t common, std::size_t left) {
    if (other.leaves >= common) {
      other.leaves -= common;
      return;
    }
    other.leaves = nearest_to(branch.points[other.leaves], line(branch.parent), left);
    other.parent = branch.parent;
  }

  static void drop_first(CrackLine& line, std::size_t count) {
    const auto drop = [&](auto& values) {
      values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    };
    drop(line.points);
    drop(line.ways);
    drop(line.times);
    line.grown -= std::min(line.grown, count);
  }

  // Arms that begin close together do so at one place.
  void settle_origin(CrackLine& branch) {
    if (branch.parent < 0) return;
    const CrackLine& from = line(branch.parent);
    if (from.ways[branch.leaves] <= m_) branch.leaves = 0;
    const bool has_both = from.grown > 0 && from.grown <= from.last();
    if (has_both && std::abs(from.ways[branch.leaves] - from.ways[from.grown]) <= 0.5 * m_)
      branch.leaves = from.grown;
  }

  // Returns the piece of a line that ends at a point, or -1.
  int piece_to(int number, std::size_t point) const {
    for (std::size_t k = 0; k < made_.pieces.size(); ++k)
      if (made_.pieces[k].line == number && made_.pieces[k].last == point)
        return static_cast<int>(k);
    return -1;
  }
  int piece_from(int number, std::size_t point) const {
    for (std::size_t k = 0; k < made_.pieces.size(); ++k)
      if (made_.pieces[k].line == number && made_.pieces[k].first == point)
        return static_cast<int>(k);
    return -1;
  }

  int parent_of_first(const CrackLine& branch) const {
    if (branch.parent < 0) return -1;
    if (branch.leaves > 0) return piece_to(branch.parent, branch.leaves);
    const int first = first_pieces_[static_cast<std::size_t>(branch.parent)];
    const LinePiece& piece = made_.pieces[static_cast<std::size_t>(first)];
    const CrackLine& from = made_.lines[static_cast<std::size_t>(branch.parent)];
    return from.parent < 0 && from.grown > piece.first ? first : piece.parent;
  }

  void cut(int number) {
    const CrackLine& whole = line(number);
    std::set<std::size_t> cuts{whole.last()};
    if (whole.grown > 0 && whole.grown < whole.last()) cuts.insert(whole.grown);
    for (const CrackLine& other : made_.lines)
      if (other.parent == number && other.leaves > 0) cuts.insert(other.leaves);
    int parent = parent_of_first(whole);
    std::size_t from = 0;
    for (const std::size_t to : cuts) {
      made_.pieces.push_back({number, from, to, parent});
      parent = static_cast<int>(made_.pieces.size()) - 1;
      if (from == 0) first_pieces_[static_cast<std::size_t>(number)] = parent;
      from = to;
    }
  }

  // Where a line leaves another, unless both are arms of a crack from its origin.
  void find_fork(int number) {
    CrackLine& branch = line(number);
    if (branch.parent < 0) return;
    CrackLine& from = line(branch.parent);
    LineFork fork;
    fork.one = piece_from(branch.parent, branch.leaves);
    fork.other = first_pieces_[static_cast<std::size_t>(number)];
    fork.parent = made_.pieces[static_cast<std::size_t>(fork.other)].parent;
    if (fork.parent < 0 || fork.one < 0 || branch.grown > branch.last()) return;
    if (branch.leaves == 0 && from.parent < 0) return;
    place(fork, from, branch);
    made_.forks.push_back(fork);
  }

  void place(LineFork& fork, CrackLine& from, CrackLine& branch) {
    const LinePiece& one = made_.pieces[static_cast<std::size_t>(fork.one)];
    const LinePiece& other = made_.pieces[static_cast<std::size_t>(fork.other)];
    const Stretch ahead = stretch_of(from, one.first, one.last, m_);
    const Stretch aside = stretch_of(branch, other.first, other.last, m_);
    const std::size_t clean_ahead = clean_from(ahead, aside, m_);
    const std::size_t clean_aside = clean_from(aside, ahead, m_);
    const auto first = middle_of(ahead, clean_ahead, m_),
               second = middle_of(aside, clean_aside, m_);
    const Vec2 rough = from.points[branch.leaves];
    const Vec2 way_ahead = first ? first->direction : from.points[ahead.last] - rough;
    const Vec2 way_aside = second ? second->direction : branch.points[aside.last] - rough;
    fork.place = rough;
    if (const auto meet = first && second ? meeting_of(*first, *second) : std::nullopt)
      if ((*meet - rough).norm() < 6.0 * m_) fork.place = *meet;
    const double cosine = way_ahead.dot(way_aside) / (way_ahead.norm() * way_aside.norm());
    fork.angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    fork.time = time_near(from, fork.place);
    move_to_fork(from, branch.leaves, clean_ahead, fork.place);
    branch.points.front() = fork.place;
    straighten(branch.points, 0, clean_aside);
  }

  static double time_near(const CrackLine& line, const Vec2& place) {
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < line.points.size(); ++k)
      if ((line.points[k] - place).norm() < (line.points[nearest] - place).norm()) nearest = k;
    return line.times[nearest];
  }

  void move_to_fork(CrackLine& line, std::size_t at, std::size_t clean, const Vec2& place) const {
    std::size_t before = at;
    while (before > 0 && (line.points[before] - place).norm() < m_) --before;
    line.points[at] = place;
    straighten(line.points, before, at);
    straighten(line.points, at, clean);
  }

  double m_;
  CrackLines made_;
  std::vector<int> first_pieces_;
};

}  // namespace

CrackLines crack_lines(const CrackGrowth& growth, const CrackSkeleton& skeleton) {
  return Maker(growth, skeleton).take();
}

}  // namespace hackle
