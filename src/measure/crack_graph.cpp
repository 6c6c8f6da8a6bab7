// SPDX-License-Identifier: MIT
#include "measure/crack_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "measure/crack_course.hpp"
#include "measure/crack_lines.hpp"
#include "scene/geometry.hpp"

namespace hackle {
namespace {

constexpr double window_of_speed = 2.0;  // horizons
constexpr double wave_at_rest = 10.0;    // horizons that a Rayleigh wave runs while a tip stays
constexpr double looks_at_rest = 3.0;
constexpr double reach_of_meeting = 2.5;  // horizons

// The end of a piece at which its line ends.
struct End {
  int piece = 0;
  bool front = false;  // the first point of the line
  CrackTip tip;
  CrackSite site = CrackSite::inside;
  double time = 0.0;
};

class GraphMaker {
 public:
  explicit GraphMaker(const CrackGrowth& growth)
      : growth_(&growth),
        found_(skeleton(growth)),
        lines_(crack_lines(growth, found_)),
        rest_(std::max(wave_at_rest * growth.m() * growth.grid().dx / growth.rayleigh(),
                       looks_at_rest * growth.interval())) {
    graph_.time = growth.time();
    graph_.rayleigh = growth.rayleigh();
    for (std::size_t k = 0; k < lines_.pieces.size(); ++k) find_ends(static_cast<int>(k));
    for (const Meeting& meeting : found_.meetings) join(meeting);
    for (End& end : ends_) join_another(end);
    make_pieces();
    make_events();
    make_tips();
    put_in_order();
  }
  CrackGraph take() { return std::move(graph_); }

 private:
  const LinePiece& piece(int number) const {
    return lines_.pieces[static_cast<std::size_t>(number)];
  }
  CrackLine& line_of(int number) {
    return lines_.lines[static_cast<std::size_t>(piece(number).line)];
  }
  const CrackLine& line_of(int number) const {
    return lines_.lines[static_cast<std::size_t>(piece(number).line)];
  }
  bool is_initial(int number) const { return piece(number).first < line_of(number).grown; }
  double horizon() const { return growth_->m() * growth_->grid().dx; }
  Vec2 in_metres(const Vec2& place) const {
    return growth_->grid().centre + growth_->grid().dx * place;
  }
  std::optional<double> dated(double time) const {
    return std::isfinite(time) && time > growth_->since() ? std::optional(time) : std::nullopt;
  }

  // The node in whose cell a place lies.
  std::pair<int, int> node_at(const Vec2& place) const {
    return {static_cast<int>(std::floor(place.x() + 0.5 * growth_->grid().nx)),
            static_cast<int>(std::floor(place.y() + 0.5 * growth_->grid().ny))};
  }
  CrackSite site_of(const Vec2& place) const {
    const auto [i, j] = node_at(place);
    if (!growth_->grid().contains(i, j)) return CrackSite::edge;
    return growth_->holds(i, j) ? CrackSite::inside : CrackSite::hole;
  }

  // A crack that begins at a rim begins in the damage beside it.
  CrackSite site_around(const Vec2& place) const {
    for (const double row : {0.0, -1.0, 1.0})
      for (const double column : {0.0, -1.0, 1.0})
        if (const CrackSite site = site_of(place + Vec2(column, row)); site != CrackSite::inside)
          return site;
    return CrackSite::inside;
  }

  void find_ends(int number) {
    const CrackLine& line = line_of(number);
    const bool has_arms = std::ranges::any_of(lines_.lines, [&](const CrackLine& other) {
      return other.parent == piece(number).line && other.leaves == 0;
    });
    if (piece(number).first == 0 && line.parent < 0 && !has_arms) add_end(number, true);
    if (piece(number).last == line.last()) add_end(number, false);
  }

  // Places the end of a line by the damage ahead of it.
  void add_end(int number, bool front) {
    CrackLine& line = line_of(number);
    End end{number, front, {}, CrackSite::inside, front ? line.times.front() : line.times.back()};
    Points last = line.points;
    if (front) std::ranges::reverse(last);
    const FittedLine ahead = direction_at_end(last);
    const std::size_t back = last.size() - 1 - std::min<std::size_t>(last.size() - 1, 2);
    const Vec2 from =
        ahead.point + (last[back] - ahead.point).dot(ahead.direction) * ahead.direction;
    const LineEnd found = end_of_line(*growth_, from, ahead.direction, growth_->m() + 4.0);
    Vec2& point = front ? line.points.front() : line.points.back();
    if (found.place != from) point = found.place;
    if (found.at_rim) end.site = site_of(found.place + ahead.direction);
    end.tip = {number, point, ahead.direction, TipState::running, 0.0};
    if (end.site != CrackSite::inside) end.tip.state = TipState::arrived;
    ends_.push_back(end);
  }

  // Of the last horizon of the way.
  FittedLine direction_at_end(const Points& points) const {
    Points last;
    for (std::size_t k = points.size(); k-- > 0;) {
      if ((points[k] - points.back()).norm() > std::max(growth_->m(), 4.0)) break;
      last.push_back(points[k]);
    }
    std::ranges::reverse(last);
    if (const auto line = fit(last)) return *line;
    const Vec2 way = points.back() - points.front();
    return {points.back(), way.norm() > 0.0 ? Vec2(way.normalized()) : Vec2(1.0, 0.0)};
  }

  int root_line(int line) const {
    while (lines_.lines[static_cast<std::size_t>(line)].parent >= 0)
      line = lines_.lines[static_cast<std::size_t>(line)].parent;
    return line;
  }

  Vec2 place_of(std::size_t node) const {
    const auto columns = static_cast<std::size_t>(growth_->grid().nx);
    return growth_->grid().from_centre(static_cast<int>(node % columns),
                                       static_cast<int>(node / columns));
  }

  struct Nearest {
    int piece = -1;
    Vec2 place{0, 0};
    double distance = std::numeric_limits<double>::infinity();
  };
  // Returns the nearest point of the pieces that `takes` takes.
  template <class Takes>
  Nearest nearest(const Vec2& place, const Takes& takes) const {
    Nearest found;
    for (std::size_t k = 0; k < lines_.pieces.size(); ++k) {
      const auto number = static_cast<int>(k);
      if (!takes(number)) continue;
      for (std::size_t l = piece(number).first; l <= piece(number).last; ++l) {
        const Vec2& point = line_of(number).points[l];
        const double distance = (point - place).norm();
        if (distance < found.distance) found = {number, point, distance};
      }
    }
    return found;
  }

  // The end of a piece that may have met something near a place.
  End* end_near(const Vec2& place, int root) {
    End* found = nullptr;
    for (End& end : ends_)
      if (root_line(piece(end.piece).line) == root && end.tip.state == TipState::running &&
          (end.tip.place - place).norm() <= reach_of_meeting * growth_->m() &&
          (found == nullptr || (end.tip.place - place).norm() < (found->tip.place - place).norm()))
        found = &end;
    return found;
  }

  void join(const Meeting& meeting) {
    const Vec2 one = place_of(meeting.one), other = place_of(meeting.other);
    const Nearest first = nearest(one, [](int) { return true; });
    if (first.piece < 0) return;
    const int root = root_line(piece(first.piece).line);
    const Nearest second =
        nearest(other, [&](int number) { return root_line(piece(number).line) != root; });
    if (second.piece < 0 || second.distance > reach_of_meeting * growth_->m()) return;
    End* const end = end_near(one, root);
    End* const against = end_near(other, root_line(piece(second.piece).line));
    if (end != nullptr && against != nullptr) {
      const Vec2 place = on_segment(end->tip.place, against->tip.place, 0.5 * (one + other));
      settle(*end, place);
      settle(*against, place);
      note_meeting(end->piece, against->piece, place, meeting.time);
    } else if (end != nullptr) {
      settle(*end, ahead_of(*end, second));
      note_meeting(end->piece, second.piece, end->tip.place, meeting.time);
    } else if (against != nullptr) {
      settle(*against, ahead_of(*against, first));
      note_meeting(against->piece, first.piece, against->tip.place, meeting.time);
    }
  }

  // Returns the point between two ends that is nearest to a place.
  static Vec2 on_segment(const Vec2& from, const Vec2& to, const Vec2& place) {
    const Vec2 way = to - from;
    const double length2 = way.squaredNorm();
    if (!(length2 > 0.0)) return from;
    return from + std::clamp((place - from).dot(way) / length2, 0.0, 1.0) * way;
  }

  // Returns the point of a crack near a place on it at which a tip aims.
  Vec2 ahead_of(const End& end, const Nearest& at) const {
    Vec2 best = at.place;
    double min = std::numeric_limits<double>::infinity();
    for (std::size_t k = piece(at.piece).first; k <= piece(at.piece).last; ++k) {
      const Vec2& point = line_of(at.piece).points[k];
      const double aside = std::abs(cross(end.tip.direction, point - end.tip.place));
      if ((point - at.place).norm() > growth_->m() || !(aside < min)) continue;
      best = point;
      min = aside;
    }
    return best;
  }

  // The branch of a crack that has come to another branch of the same one.
  void join_another(End& end) {
    if (end.tip.state != TipState::running) return;
    const Nearest other = nearest(
        end.tip.place, [&](int number) { return piece(number).line != piece(end.piece).line; });
    if (other.piece < 0 || other.distance > growth_->m() + 2.5) return;
    const Vec2 way = other.place - end.tip.place;
    if (way.dot(end.tip.direction) < 0.5 * way.norm()) return;
    for (double share = 0.0; share <= 1.0; share += 0.5 / (1.0 + way.norm())) {
      const auto [i, j] = node_at(end.tip.place + share * way);
      if (!growth_->grid().contains(i, j)) return;
      if (growth_->arrival(growth_->grid().index(i, j)) == CrackGrowth::never) return;
    }
    settle(end, other.place);
    note_meeting(end.piece, other.piece, other.place, end.time);
  }

  void settle(End& end, const Vec2& place) {
    end.tip.state = TipState::joined;
    end.tip.place = place;
    CrackLine& line = line_of(end.piece);
    (end.front ? line.points.front() : line.points.back()) = place;
  }

  void note_meeting(int one, int other, const Vec2& place, double time) {
    CrackEvent event;
    event.kind = CrackEventKind::coalescence;
    event.time = dated(time);
    event.place = in_metres(place);
    event.crack = one;
    event.other = other;
    graph_.events.push_back(event);
  }

  void make_pieces() {
    for (std::size_t k = 0; k < lines_.pieces.size(); ++k) {
      const auto number = static_cast<int>(k);
      const CrackLine& line = line_of(number);
      CrackPiece made;
      made.parent = piece(number).parent;
      made.initial = is_initial(number);
      for (std::size_t l = piece(number).first; l <= piece(number).last; ++l) {
        made.points.push_back(in_metres(line.points[l]));
        made.times.push_back(made.initial ? CrackGrowth::at_start : line.times[l]);
      }
      for (std::size_t l = 1; l < made.points.size(); ++l)
        made.length += (made.points[l] - made.points[l - 1]).norm();
      const TipCourse course = course_to(number);
      const auto own = static_cast<std::size_t>(
          std::ranges::count_if(made.times, [&](double time) { return dated(time).has_value(); }));
      made.max_speed = max_speed(course, window_of_speed * horizon(),
                                 course.size() - std::min(own, course.size()));
      graph_.cracks.push_back(std::move(made));
    }
  }

  // The way of the tip to the end of a piece, from where it was first seen on its way.
  TipCourse course_to(int number) const {
    std::vector<int> chain;
    for (int one = number; one >= 0 && !is_initial(one); one = piece(one).parent)
      chain.push_back(one);
    std::ranges::reverse(chain);
    TipCourse course;
    double before = 0.0;
    for (const int one : chain) {
      const CrackLine& line = line_of(one);
      for (std::size_t k = piece(one).first; k <= piece(one).last; ++k) {
        if (!dated(line.times[k])) continue;
        course.ways.push_back(before +
                              growth_->grid().dx * (line.ways[k] - line.ways[piece(one).first]));
        const double earliest = course.times.empty() ? line.times[k] : course.times.back();
        course.times.push_back(std::max(earliest, line.times[k]));
      }
      before += growth_->grid().dx * (line.ways[piece(one).last] - line.ways[piece(one).first]);
    }
    return course;
  }

  void make_events() {
    for (std::size_t k = 0; k < lines_.pieces.size(); ++k) note_birth(static_cast<int>(k));
    for (const LineFork& fork : lines_.forks) note_fork(fork);
    for (std::size_t k = 0; k < lines_.pieces.size(); ++k) note_rests(static_cast<int>(k));
    for (End& end : ends_) note_end(end);
  }

  // A crack that hangs on none is born at its origin; its second arm is not born again.
  void note_birth(int number) {
    const CrackLine& line = line_of(number);
    if (line.parent >= 0 || piece(number).first > 0 || is_initial(number)) return;
    CrackEvent event;
    event.kind = CrackEventKind::nucleation;
    event.time = dated(line.times.front());
    event.place = in_metres(line.points.front());
    event.crack = number;
    event.site = site_around(line.points.front());
    graph_.events.push_back(event);
  }

  void note_fork(const LineFork& fork) {
    if (is_initial(fork.other)) return;
    CrackEvent event;
    event.kind = CrackEventKind::branch;
    event.time = dated(fork.time);
    event.place = in_metres(fork.place);
    event.crack = fork.parent;
    event.angle = fork.angle;
    const TipCourse course = course_to(fork.parent);
    if (course.size() > 0)
      event.speed = speed_at(course, course.size() - 1, window_of_speed * horizon());
    graph_.events.push_back(event);
  }

  // Where a tip stood and went on later.
  void note_rests(int number) {
    if (is_initial(number)) return;
    const CrackLine& line = line_of(number);
    for (std::size_t k = piece(number).first; k < piece(number).last; ++k) {
      const bool stood = dated(line.times[k]) && line.times[k + 1] - line.times[k] > rest_;
      if (stood && line.ways[k] - line.ways[piece(number).first] >= growth_->m())
        note_arrest(number, line.points[k], line.times[k]);
    }
  }

  void note_arrest(int number, const Vec2& place, double time) {
    CrackEvent event;
    event.kind = CrackEventKind::arrest;
    event.time = dated(time);
    event.place = in_metres(place);
    event.crack = number;
    event.speed = speed_until(number, time);
    graph_.events.push_back(event);
  }

  std::optional<double> speed_until(int number, double time) const {
    const TipCourse course = course_to(number);
    std::size_t count = 0;
    while (count < course.size() && course.times[count] <= time) ++count;
    if (count == 0) return std::nullopt;
    return speed_at(course, count - 1, window_of_speed * horizon());
  }

  void note_end(End& end) {
    if (is_initial(end.piece)) {
      end.tip.state = TipState::initial;
      return;
    }
    if (end.front) return;
    const TipCourse course = course_to(end.piece);
    if (course.size() > 0)
      end.tip.speed =
          speed_now(course, window_of_speed * horizon(), growth_->time(), growth_->grid().dx);
    if (end.tip.state == TipState::arrived) {
      CrackEvent event;
      event.kind = CrackEventKind::arrival;
      event.time = dated(end.time);
      event.place = in_metres(end.tip.place);
      event.crack = end.piece;
      event.site = end.site;
      event.speed = speed_until(end.piece, end.time);
      graph_.events.push_back(event);
    } else if (end.tip.state == TipState::running && dated(end.time) &&
               growth_->time() - end.time > rest_) {
      end.tip.state = TipState::arrested;
      note_arrest(end.piece, end.tip.place, end.time);
    }
    if (end.tip.state != TipState::running) end.tip.speed = 0.0;
  }

  // An end at the rim, or where a crack has met another, was a tip.
  void make_tips() {
    for (const End& end : ends_) {
      const bool at_rim = end.site != CrackSite::inside;
      if (at_rim && (end.front || is_initial(end.piece))) continue;
      CrackTip tip = end.tip;
      tip.place = in_metres(tip.place);
      graph_.tips.push_back(tip);
    }
  }

  void put_in_order() {
    std::vector<int> order(graph_.cracks.size()), numbers(graph_.cracks.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int number) {
      const CrackPiece& one = graph_.cracks[static_cast<std::size_t>(number)];
      return std::tuple(one.initial ? CrackGrowth::at_start : one.times.front(), generation(number),
                        one.points.back().x(), one.points.back().y());
    };
    std::ranges::stable_sort(order, {}, key);
    std::vector<CrackPiece> sorted;
    for (std::size_t k = 0; k < order.size(); ++k) {
      numbers[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
      sorted.push_back(std::move(graph_.cracks[static_cast<std::size_t>(order[k])]));
    }
    graph_.cracks = std::move(sorted);
    const auto renumber = [&](int& number) {
      if (number >= 0) number = numbers[static_cast<std::size_t>(number)];
    };
    for (CrackPiece& one : graph_.cracks) renumber(one.parent);
    for (CrackTip& tip : graph_.tips) renumber(tip.crack);
    for (CrackEvent& event : graph_.events) {
      renumber(event.crack);
      renumber(event.other);
    }
    std::ranges::stable_sort(graph_.tips, {}, &CrackTip::crack);
    std::ranges::stable_sort(graph_.events, {}, [](const CrackEvent& event) {
      return std::tuple(event.time.value_or(CrackGrowth::at_start), event.kind, event.place.x(),
                        event.place.y());
    });
  }

  int generation(int number) const {
    int count = 0;
    while ((number = piece(number).parent) >= 0) ++count;
    return count;
  }

  const CrackGrowth* growth_;
  CrackSkeleton found_;
  CrackLines lines_;
  double rest_;  // s
  std::vector<End> ends_;
  CrackGraph graph_;
};

}  // namespace

std::string_view name_of(CrackEventKind kind) {
  static constexpr auto names =
      std::to_array<std::string_view>({"nucleation", "branch", "coalescence", "arrest", "arrival"});
  return names[static_cast<std::size_t>(kind)];
}

std::string_view name_of(CrackSite site) {
  static constexpr auto names = std::to_array<std::string_view>({"inside", "edge", "hole"});
  return names[static_cast<std::size_t>(site)];
}

std::string_view name_of(TipState state) {
  static constexpr auto names =
      std::to_array<std::string_view>({"initial", "running", "arrested", "arrived", "joined"});
  return names[static_cast<std::size_t>(state)];
}

CrackGraph crack_graph(const CrackGrowth& growth) {
  if (growth.empty()) {
    CrackGraph none;
    none.time = growth.time();
    none.rayleigh = growth.rayleigh();
    return none;
  }
  return GraphMaker(growth).take();
}

}  // namespace hackle
