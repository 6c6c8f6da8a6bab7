// SPDX-License-Identifier: MIT
// The graph of cracks that are drawn as cut bonds, whose course is known: places within half a
// spacing, angles within 2 degrees, no event that did not happen, in any direction and for any m.
#include "measure/crack_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lattice/crack_cut.hpp"
#include "measure/crack_lines.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double spacing_of_drawing = 0.5e-3;

// A plate of nx by ny nodes in which bonds are cut along lines, in spacings from its centre.
class Drawing {
 public:
  // `start` is a crack of the scene.
  Drawing(int nx, int ny, double m, const std::vector<Vec2>& start = {})
      : plate_(with_crack(test::bare_plate(nx, ny), start)),
        numerics_(test::numerics(spacing_of_drawing, m * spacing_of_drawing)),
        lattice_(plate_, numerics_),
        state_(lattice_, Precision::f64) {
    state_.bonds = lattice_.bonds;
  }

  // Long lines in pieces: the work grows with the box around each.
  void line(const std::vector<Vec2>& points) {
    std::vector<Vec2> places{in_metres(points.front())};
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const Vec2 way = points[k + 1] - points[k];
      const int pieces = std::max(1, static_cast<int>(way.norm() / 6.0));
      for (int l = 1; l <= pieces; ++l)
        places.push_back(in_metres(points[k] + static_cast<double>(l) / pieces * way));
    }
    cut(Crack(places, Born::broken), lattice_.grid, lattice_.family, state_.bonds);
  }
  // Breaks bonds at random in a disc.
  void cloud(const Vec2& centre, double radius, double share) {
    const NodeLayout layout = lattice_.grid.layout();
    lattice_.family.for_each_bond([&](int, int, const Vec2&, double, int bit) {
      for (int j = 0; j < lattice_.grid.ny; ++j)
        for (int i = 0; i < lattice_.grid.nx; ++i)
          if ((lattice_.grid.from_centre(i, j) - centre).norm() < radius && draw() < share)
            state_.bonds.clear(layout.at(i, j), bit);
    });
  }
  void look(double time) {
    state_.clock.moment = time;
    const std::vector<double> cold;
    growth_.look(View(plate_, numerics_, lattice_, 1e-7, state_, cold));
  }
  CrackGraph graph() const { return crack_graph(growth_); }
  const CrackGrowth& growth() const { return growth_; }
  // Returns the node in whose cell a place lies.
  std::size_t node_at(const Vec2& place) const {
    const Grid& grid = lattice_.grid;
    return grid.index(static_cast<int>(std::floor(place.x() + 0.5 * grid.nx)),
                      static_cast<int>(std::floor(place.y() + 0.5 * grid.ny)));
  }
  // Returns a place, m, in spacings from the centre.
  Vec2 drawn(const Vec2& place) const { return lattice_.grid.from_centre(place); }

 private:
  static Plate with_crack(Plate plate, const std::vector<Vec2>& points) {
    std::vector<Vec2> places;
    for (const Vec2& point : points)
      places.push_back(0.5 * Vec2(plate.width, plate.height) + spacing_of_drawing * point);
    if (!places.empty()) plate.cracks.emplace_back(places, Born::broken);
    return plate;
  }
  Vec2 in_metres(const Vec2& point) const {
    return lattice_.grid.centre + lattice_.grid.dx * point;
  }
  double draw() { return uniform_(random_); }

  Plate plate_;
  Numerics numerics_;
  Lattice lattice_;
  State state_;
  CrackGrowth growth_;
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

Vec2 turned(const Vec2& point, double angle) {
  return {point.x() * std::cos(angle) - point.y() * std::sin(angle),
          point.x() * std::sin(angle) + point.y() * std::cos(angle)};
}

double distance_to_tip(const Drawing& drawing, const CrackGraph& graph, const Vec2& place) {
  double min = 1e9;
  for (const CrackTip& tip : graph.tips)
    min = std::min(min, (drawing.drawn(tip.place) - place).norm());
  return min;
}

int count(const CrackGraph& graph, CrackEventKind kind) {
  return static_cast<int>(std::ranges::count(graph.events, kind, &CrackEvent::kind));
}

// Returns the first event of a kind; there must be one.
std::vector<CrackEvent>::const_iterator first_of(const CrackGraph& graph, CrackEventKind kind) {
  return std::ranges::find(graph.events, kind, &CrackEvent::kind);
}

TEST(CrackGraph, AStraightCrackHasTwoTipsAndALength) {
  for (const double m : {3.0, 4.0, 8.0, 16.0})
    for (const double angle : {0.0, 10.0, 22.5, 45.0}) {
      if (m > 8.0 && angle != 22.5) continue;
      Drawing drawing(110, 110, m);
      const Vec2 middle(0.3, 0.1);
      const Vec2 from = middle + turned({-40.3, 0.0}, angle * degree);
      const Vec2 to = middle + turned({45.0, 0.0}, angle * degree);
      drawing.line({from, to});
      drawing.look(1e-6);
      const CrackGraph graph = drawing.graph();
      const std::string which = fmt::format("m = {}, {} degrees", m, angle);
      ASSERT_EQ(graph.cracks.size(), 1U) << which;
      ASSERT_EQ(graph.tips.size(), 2U) << which;
      EXPECT_LT(distance_to_tip(drawing, graph, from), 0.5) << which;
      EXPECT_LT(distance_to_tip(drawing, graph, to), 0.5) << which;
      EXPECT_NEAR(graph.cracks.front().length / spacing_of_drawing, 85.3, 1.0) << which;
      for (const Vec2& point : graph.cracks.front().points) {
        const Vec2 place = turned(drawing.drawn(point) - middle, -angle * degree);
        EXPECT_LT(std::abs(place.y()), 0.5) << which << " at " << place.x();
      }
      EXPECT_EQ(graph.events.size(), 1U) << which;  // its nucleation
    }
}

TEST(CrackGraph, AForkHasItsPlaceAndAngle) {
  for (const double m : {3.0, 4.0, 8.0, 16.0})
    for (const double between : {20.0, 40.0, 60.0})
      for (const double angle : {0.0, 17.0, 30.0, 45.0}) {
        const bool is_large = m > 4.0, is_turned = angle == 17.0 || angle == 45.0;
        if ((is_large && is_turned) || (m > 8.0 && between != 40.0)) continue;
        const double reach = std::max(55.0, 7.5 * m);
        const int size = 2 * static_cast<int>(reach + 15.0);
        const Vec2 fork = turned({-0.3 * reach, 0.2}, angle * degree);
        const auto away = [&](double direction, double length) {
          return Vec2(fork + turned({length, 0.0}, (angle + direction) * degree));
        };
        Drawing drawing(size, size, m, {away(180.0, 0.5 * reach), away(180.0, 0.25 * reach)});
        drawing.line({away(180.0, 0.5 * reach), fork, away(0.5 * between, reach)});
        drawing.line({fork, away(-0.5 * between, reach)});
        drawing.look(1e-6);
        const CrackGraph graph = drawing.graph();
        const std::string which = fmt::format("m = {}, {} degrees, turned {}", m, between, angle);
        EXPECT_EQ(count(graph, CrackEventKind::branch), 1) << which;
        if (count(graph, CrackEventKind::branch) != 1) continue;
        const auto found = first_of(graph, CrackEventKind::branch);
        const Vec2 error = turned(drawing.drawn(found->place) - fork, -angle * degree);
        // Half a spacing across the branches, as far as bonds tell where they run.
        const double along = std::max(0.5, 0.3 / std::sin(0.5 * between * degree));
        EXPECT_LT(std::abs(error.x()), along) << which << ": " << error.transpose();
        EXPECT_LT(std::abs(error.y()), 0.5) << which << ": " << error.transpose();
        EXPECT_NEAR(*found->angle / degree, between, 2.0) << which;
        EXPECT_EQ(graph.events.size(), 1U) << which;
        EXPECT_EQ(graph.tips.size(), 3U) << which;
        EXPECT_EQ(graph.cracks.size(), 4U) << which;  // one of the scene, three grown
      }
}

TEST(CrackGraph, ACurvedCrackStaysOnItsCircle) {
  for (const double m : {3.0, 4.0, 8.0}) {
    constexpr double radius = 60.0;
    std::vector<Vec2> points;
    for (int k = -60; k <= 60; ++k) points.push_back(turned({radius, 0.0}, k * degree));
    for (Vec2& point : points) point -= Vec2(40.0, 0.0);
    Drawing drawing(160, 160, m);
    drawing.line(points);
    drawing.look(1e-6);
    const CrackGraph graph = drawing.graph();
    ASSERT_EQ(graph.cracks.size(), 1U) << m;
    EXPECT_EQ(graph.events.size(), 1U) << m;
    for (const Vec2& point : graph.cracks.front().points) {
      const Vec2 place = drawing.drawn(point) + Vec2(40.0, 0.0);
      EXPECT_LT(std::abs(place.norm() - radius), 0.5) << m << " at " << place.transpose();
    }
  }
}

TEST(CrackGraph, ACloudIsNoCrack) {
  for (const double m : {3.0, 4.0, 8.0})
    for (const double share : {0.1, 0.3, 0.45, 0.7}) {
      Drawing drawing(120, 120, m);
      drawing.cloud({0.0, 0.0}, 6.0 * m, share);
      drawing.look(1e-6);
      EXPECT_TRUE(drawing.graph().cracks.empty()) << m << " " << share;
    }
}

TEST(CrackGraph, ACloudAroundACrackDoesNotForkIt) {
  for (const double m : {3.0, 4.0, 8.0}) {
    Drawing drawing(160, 100, m);
    drawing.line({{-60.0, 0.2}, {50.0, 0.2}});
    drawing.cloud({0.0, 6.0}, 4.0 * m, 0.1);
    drawing.look(1e-6);
    const CrackGraph graph = drawing.graph();
    EXPECT_EQ(graph.cracks.size(), 1U) << m;
    EXPECT_EQ(count(graph, CrackEventKind::branch), 0) << m;
    EXPECT_LT(distance_to_tip(drawing, graph, {50.0, 0.2}), 0.5) << m;
  }
}

constexpr double look_of_drawing = 0.2e-6;   // s
constexpr double speed_of_drawing = 1500.0;  // m/s
constexpr double pace_of_drawing =
    speed_of_drawing * look_of_drawing / spacing_of_drawing;  // spacings per look

// Lets lines grow from their first points towards their second ones at the same speed, from a time
// on; returns when the longest has come to its end.
double run(Drawing& drawing, const std::vector<Segment>& lines, double time) {
  bool runs = true;
  for (int k = 1; runs; ++k) {
    runs = false;
    for (const Segment& line : lines) {
      const double length = (line.to - line.from).norm(),
                   way = std::min(length, k * pace_of_drawing);
      const double back = std::max(0.0, way - 2.0 * pace_of_drawing);
      const Vec2 along = (line.to - line.from) / length;
      drawing.line({line.from + back * along, line.from + way * along});
      runs = runs || way < length;
    }
    time += look_of_drawing;
    drawing.look(time);
  }
  return time;
}

TEST(CrackGraph, ATipHasItsSpeedAndStands) {
  for (const double m : {3.0, 4.0, 8.0})
    for (const double angle : {0.0, 20.0}) {
      const auto at = [&](double x) { return turned({x, 0.2}, angle * degree); };
      Drawing drawing(140, 120, m, {at(-50.0), at(-30.0)});
      drawing.look(0.0);
      const double end = run(drawing, {{at(-30.0), at(40.0)}}, 0.0);
      CrackGraph graph = drawing.graph();
      ASSERT_EQ(graph.cracks.size(), 2U) << m << " " << angle;
      EXPECT_TRUE(graph.cracks[0].initial);
      EXPECT_EQ(graph.cracks[1].parent, 0);
      EXPECT_NEAR(graph.cracks[1].length / spacing_of_drawing, 70.0, 1.5);
      ASSERT_EQ(graph.tips.size(), 2U);
      EXPECT_EQ(graph.tips[0].state, TipState::initial);
      EXPECT_EQ(graph.tips[1].state, TipState::running);
      EXPECT_NEAR(graph.tips[1].speed, speed_of_drawing, 0.05 * speed_of_drawing) << m << angle;
      EXPECT_NEAR(*graph.cracks[1].max_speed, speed_of_drawing, 0.15 * speed_of_drawing) << m;
      EXPECT_TRUE(graph.events.empty()) << m << " " << angle;

      for (int k = 1; k <= 10; ++k) drawing.look(end + 2e-6 * k);
      graph = drawing.graph();
      ASSERT_EQ(graph.events.size(), 1U) << m << " " << angle;
      EXPECT_EQ(graph.events[0].kind, CrackEventKind::arrest);
      EXPECT_NEAR(*graph.events[0].time, end, 3.0 * look_of_drawing);
      EXPECT_LT((drawing.drawn(graph.events[0].place) - at(40.0)).norm(), 0.5) << m << angle;
      EXPECT_EQ(graph.tips[1].state, TipState::arrested);
      EXPECT_EQ(graph.tips[1].speed, 0.0);
    }
}

TEST(CrackGraph, AForkIsDatedAndHasThreeParts) {
  for (const double m : {3.0, 4.0, 8.0}) {
    const Vec2 fork(0.0, 0.2);
    Drawing drawing(200, 160, m, {{-100.0, 0.2}, {-40.0, 0.2}});
    drawing.look(0.0);
    const double forked = run(drawing, {{{-40.0, 0.2}, fork}}, 0.0);
    const Vec2 up = fork + turned({70.0, 0.0}, 25.0 * degree);
    const Vec2 down = fork + turned({70.0, 0.0}, -25.0 * degree);
    run(drawing, {{fork, up}, {fork, down}}, forked);
    const CrackGraph graph = drawing.graph();
    ASSERT_EQ(graph.events.size(), 1U) << m;
    const CrackEvent& event = graph.events.front();
    EXPECT_EQ(event.kind, CrackEventKind::branch);
    EXPECT_NEAR(*event.time, forked, 4.0 * look_of_drawing) << m;
    EXPECT_LT((drawing.drawn(event.place) - fork).norm(), 0.5) << m;
    EXPECT_NEAR(*event.angle / degree, 50.0, 2.0) << m;
    ASSERT_EQ(graph.cracks.size(), 4U) << m;
    EXPECT_EQ(event.crack, 1);
    EXPECT_NEAR(*event.speed, speed_of_drawing, 0.1 * speed_of_drawing) << m;
    for (const std::size_t branch : {2U, 3U}) {
      EXPECT_EQ(graph.cracks[branch].parent, 1);
      EXPECT_NEAR(graph.cracks[branch].length / spacing_of_drawing, 70.0, 2.0) << m;
    }
    ASSERT_EQ(graph.tips.size(), 2U) << m;  // the crack of the scene began at the edge
  }
}

TEST(CrackGraph, ACrackArrivesAtAnEdge) {
  Drawing drawing(100, 60, 4.0, {{-50.0, 0.2}, {-20.0, 0.2}});
  drawing.look(0.0);
  const double end = run(drawing, {{{-20.0, 0.2}, {51.0, 0.2}}}, 0.0);
  drawing.look(end + 30e-6);
  const CrackGraph graph = drawing.graph();
  ASSERT_EQ(graph.events.size(), 1U);
  EXPECT_EQ(graph.events[0].kind, CrackEventKind::arrival);
  EXPECT_EQ(graph.events[0].site, CrackSite::edge);
  EXPECT_LT((drawing.drawn(graph.events[0].place) - Vec2(50.0, 0.2)).norm(), 0.5);
  EXPECT_NEAR(*graph.events[0].time, end, 6.0 * look_of_drawing);
  ASSERT_EQ(graph.tips.size(), 1U);
  EXPECT_EQ(graph.tips[0].state, TipState::arrived);
}

TEST(CrackGraph, ACrackIsBornAmidThePlate) {
  Drawing drawing(140, 80, 4.0);
  drawing.look(0.0);
  drawing.look(2e-6);
  run(drawing, {{{0.0, 0.2}, {40.0, 0.2}}, {{0.0, 0.2}, {-40.0, 0.2}}}, 2e-6);
  const CrackGraph graph = drawing.graph();
  ASSERT_EQ(graph.events.size(), 1U);
  EXPECT_EQ(graph.events[0].kind, CrackEventKind::nucleation);
  EXPECT_EQ(graph.events[0].site, CrackSite::inside);
  EXPECT_LT((drawing.drawn(graph.events[0].place) - Vec2(0.0, 0.2)).norm(), 2.0);
  EXPECT_NEAR(*graph.events[0].time, 2e-6, 3.0 * look_of_drawing);
  EXPECT_EQ(graph.tips.size(), 2U);
}

TEST(CrackGraph, ACrackIsBornAtAnEdge) {
  Drawing drawing(100, 60, 4.0);
  drawing.look(0.0);
  drawing.look(2e-6);
  run(drawing, {{{-50.0, 0.2}, {10.0, 0.2}}}, 2e-6);
  const CrackGraph graph = drawing.graph();
  const auto born = first_of(graph, CrackEventKind::nucleation);
  ASSERT_NE(born, graph.events.end());
  EXPECT_EQ(born->site, CrackSite::edge);
}

TEST(CrackGraph, CracksThatMeetCoalesceAndDoNotFork) {
  for (const bool head_on : {true, false}) {
    const Segment one{{-60.0, 0.2}, {head_on ? 0.0 : 20.0, 0.2}};
    const Segment other =
        head_on ? Segment{{60.0, 0.2}, {0.0, 0.2}} : Segment{{20.2, -45.0}, {20.2, 30.0}};
    Drawing drawing(160, 120, 4.0);
    drawing.look(0.0);
    const double end = run(drawing, {one, other}, 0.0);
    const CrackGraph graph = drawing.graph();
    EXPECT_EQ(count(graph, CrackEventKind::branch), 0) << head_on;
    EXPECT_EQ(count(graph, CrackEventKind::nucleation), 2) << head_on;
    ASSERT_EQ(count(graph, CrackEventKind::coalescence), 1) << head_on;
    const auto met = first_of(graph, CrackEventKind::coalescence);
    EXPECT_LT((drawing.drawn(met->place) - one.to).norm(), 1.0) << head_on;
    EXPECT_GT(*met->time, 0.8 * end) << head_on;
    EXPECT_NE(met->crack, met->other);
  }
}

TEST(CrackGraph, OfAMirrorImageIsTheMirrorImage) {
  std::vector<CrackGraph> graphs;
  std::vector<Vec2> tips[2];
  for (const double side : {1.0, -1.0}) {
    const auto at = [&](double x, double y) { return Vec2(x, side * y); };
    Drawing drawing(160, 120, 4.0, {at(-80.0, 3.2), at(-50.0, 3.2)});
    drawing.look(0.0);
    double time = run(drawing, {{at(-50.0, 3.2), at(-20.0, 3.2)}}, 0.0);
    time = run(drawing, {{at(-20.0, 3.2), at(40.0, 25.0)}, {at(-20.0, 3.2), at(50.0, -8.0)}}, time);
    graphs.push_back(drawing.graph());
    for (const CrackTip& tip : graphs.back().tips)
      tips[side < 0.0].push_back(at(drawing.drawn(tip.place).x(), drawing.drawn(tip.place).y()));
    for (const CrackEvent& event : graphs.back().events)
      tips[side < 0.0].push_back(
          at(drawing.drawn(event.place).x(), drawing.drawn(event.place).y()));
  }
  ASSERT_EQ(tips[0].size(), 3U);
  ASSERT_EQ(tips[1].size(), 3U);
  for (const Vec2& one : tips[0]) {
    double nearest = 1e9;
    for (const Vec2& other : tips[1]) nearest = std::min(nearest, (one - other).norm());
    EXPECT_LT(nearest, 0.5) << one.transpose();
  }
}

// A branch whose path runs beside another for long loses its first points; what hangs on it stays
// where it is.
TEST(CrackLines, ABranchOfAShortenedBranchStaysInItsPlace) {
  Drawing drawing(120, 80, 4.0);
  const Vec2 along(-20.0, 0.5), first(0.0, 0.5), second(30.0, 12.5);
  drawing.line({{-50.0, 0.5}, {50.0, 0.5}});
  drawing.line({first, {40.0, 16.5}});
  drawing.line({second, {50.0, 12.5}});
  drawing.look(1e-6);
  const auto path = [&](const std::vector<Vec2>& corners) {
    std::vector<std::size_t> nodes;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      const double length = corners[k + 1].x() - corners[k].x();
      for (double way = 0.0; way < length; way += 1.0)
        nodes.push_back(drawing.node_at(corners[k] + way / length * (corners[k + 1] - corners[k])));
    }
    return nodes;
  };
  CrackSkeleton skeleton;
  skeleton.paths.push_back({path({{-50.0, 0.5}, {50.0, 0.5}}), -1, 0});
  skeleton.paths.push_back({path({along, first, {40.0, 16.5}}), 0, 30});
  skeleton.paths.push_back({path({second, {50.0, 12.5}}), 1, 50});
  const CrackLines lines = crack_lines(drawing.growth(), skeleton);
  const CrackLine& branch = lines.lines[1];
  EXPECT_GT(branch.points.front().x(), -5.0);  // it has lost what it had in common
  ASSERT_LE(lines.lines[2].leaves, branch.last());
  // The middles of two cracks are one up to two horizons behind their fork.
  EXPECT_LT((branch.points[lines.lines[2].leaves] - second).norm(), 2.0 * 4.0);
}

}  // namespace
}  // namespace hackle
