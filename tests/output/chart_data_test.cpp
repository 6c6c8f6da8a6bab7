// SPDX-License-Identifier: MIT
#include "output/chart_data.hpp"

#include <gmock/gmock.h>

#include "measure/energy.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using Points = std::vector<Vec2>;

Simulation simulation(const Loads& loads) {
  Plate plate = test::edge_crack(12e6);
  plate.loads = loads;
  return {plate, test::numerics(2e-3, 8e-3), {1}};
}

Traction traction(Edge edge, double stress, Course course = {}) {
  return {edge, VectorField(0.0, stress), 0.0, std::move(course)};
}

TEST(LoadCurve, IsInPascalWhereThereAreStressesOnly) {
  Loads loads;
  loads.tractions = {traction(Edge::top, 12e6, ramp(4e-6)),
                     traction(Edge::bottom, -12e6, ramp(4e-6))};
  Simulation s = simulation(loads);
  s.run(1e-5);
  const Chart chart = load_curve(s);
  EXPECT_EQ(chart.unit, "Pa");
  EXPECT_EQ(chart.until, std::max(s.end_time(), s.time()));
  ASSERT_EQ(chart.curves.size(), 2U);
  EXPECT_EQ(chart.curves[0].kind, "traction");
  EXPECT_EQ(chart.curves[0].place, "top");
  EXPECT_EQ(chart.curves[1].points, chart.curves[0].points);
  EXPECT_EQ(chart.curves[0].points, (Points{{0.0, 0.0}, {4e-6, 12e6}, {chart.until, 12e6}}));
}

TEST(LoadCurve, AFunctionIsKnownAtThePresentOnly) {
  Loads loads;
  const Course wave([](double t) { return 1e5 * t; }, "a wave");
  loads.tractions = {traction(Edge::top, 12e6, wave), traction(Edge::bottom, -6e6)};
  Simulation s = simulation(loads);
  s.run(1e-5);
  const Chart chart = load_curve(s);
  ASSERT_EQ(chart.curves.size(), 2U);
  EXPECT_EQ(chart.curves[0].points, (Points{{s.time(), 12e6 * (1e5 * s.time())}}));
  EXPECT_EQ(chart.curves[1].points.size(), 2U);
}

TEST(LoadCurve, LoadsOfSeveralUnitsShowTheirFactors) {
  Loads loads;
  loads.tractions = {traction(Edge::top, 12e6)};
  Support pull;
  pull.value = VectorField(0.0, 1e-6);
  pull.course = ramp(2e-6);
  Support clamp;
  loads.supports = {pull, clamp};
  const Chart chart = load_curve(simulation(loads));
  EXPECT_EQ(chart.unit, "");
  EXPECT_EQ(chart.heading, "load factor");
  ASSERT_EQ(chart.curves.size(), 2U) << "a clamp is no load";
  EXPECT_EQ(chart.curves[0].points.front().y(), 1.0);
  EXPECT_EQ(chart.curves[1].points.front().y(), 0.0);
  EXPECT_EQ(chart.curves[1].points.back().y(), 1.0);
}

TEST(LoadCurve, TellsLoadsOfTheSameEdgeApart) {
  Loads loads;
  loads.tractions = {traction(Edge::top, 12e6), traction(Edge::top, 6e6), traction(Edge::left, 1e6),
                     traction(Edge::top, 3e6)};
  const Chart chart = load_curve(simulation(loads));
  std::vector<std::string> places;
  for (const Curve& curve : chart.curves) places.push_back(curve.place);
  EXPECT_EQ(places, (std::vector<std::string>{"top", "top 2", "left", "top 3"}));
}

TEST(LoadCurve, SaysWhenThereAreNone) {
  const Chart chart = load_curve(simulation({}));
  EXPECT_EQ(chart.heading, "no loads");
  EXPECT_TRUE(chart.curves.empty());
  EXPECT_GT(chart.until, 0.0);
}

TEST(EnergyChart, IsTheLedgerNow) {
  Loads loads;
  loads.tractions = {traction(Edge::top, 12e6), traction(Edge::bottom, -12e6)};
  Simulation s = simulation(loads);
  s.run(5e-6);
  const Energy ledger = energy(s);
  const Chart chart = energy_chart(s);
  ASSERT_EQ(chart.curves.size(), 3U);
  EXPECT_EQ(chart.curves[0].points, (Points{{s.time(), ledger.kinetic}}));
  EXPECT_EQ(chart.curves[1].points, (Points{{s.time(), ledger.strain}}));
  EXPECT_EQ(chart.curves[2].points, (Points{{s.time(), ledger.broken}}));
  EXPECT_GT(ledger.kinetic, 0.0);
}

TEST(EnergyChart, IsRefusedForAPictureAlone) {
  PictureOptions options;
  EXPECT_NO_THROW(check_alone("frame", options));
  options.overlay.energy = true;
  try {
    check_alone("frame", options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("frame: energy"));
    EXPECT_THAT(error.what(), HasSubstr("s:movie"));
  }
}

}  // namespace
}  // namespace hackle
