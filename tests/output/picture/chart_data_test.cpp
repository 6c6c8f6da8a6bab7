// SPDX-License-Identifier: MIT
#include "output/picture/chart_data.hpp"

#include <gmock/gmock.h>

#include "measure/energy.hpp"
#include "solver/simulation.hpp"
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

Traction traction(Edge edge, double stress, Amplitude amplitude = {}) {
  return {edge, VectorField(0.0, stress), 0.0, std::move(amplitude)};
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

// A run that ends on the way up shows where it was going.
TEST(LoadCurve, ShowsTheWholeCourse) {
  Loads loads;
  loads.tractions = {traction(Edge::top, 12e6, ramp(40e-6))};
  Simulation s = simulation(loads);
  s.run(1e-5);
  const Chart chart = load_curve(s);
  EXPECT_DOUBLE_EQ(chart.until, 50e-6);
  EXPECT_EQ(chart.curves.at(0).points, (Points{{0.0, 0.0}, {40e-6, 12e6}, {chart.until, 12e6}}));
}

TEST(LoadCurve, AFunctionIsKnownAtThePresentOnly) {
  Loads loads;
  const Amplitude wave([](double t) { return 1e5 * t; }, "a wave");
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
  pull.amplitude = ramp(2e-6);
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

TEST(LoadCurve, NamesEveryKindOfLoadAndItsPlace) {
  Plate plate = test::bare_plate(40, 20);
  plate.material.alphaT = 1e-6;
  plate.cutouts.push_back({rectangle({5e-3, 2.5e-3}, {7.5e-3, 5e-3}), "bore"});
  plate.loads.tractions.push_back({Edge::left, {3.0, 4.0}, 0.0, ramp(1e-6)});
  plate.loads.pressures.push_back({"bore", 6.0, ramp(2e-6)});
  const Chart stresses = load_curve(Simulation(plate, test::numerics(), {1}));
  EXPECT_EQ(stresses.heading, "load");
  EXPECT_EQ(stresses.unit, "Pa");
  EXPECT_DOUBLE_EQ(stresses.until, 2.5e-6);  // a quarter more than the last time
  ASSERT_EQ(stresses.curves.size(), 2U);
  EXPECT_EQ(stresses.curves[0].place, "left");
  EXPECT_EQ(stresses.curves[0].points.back(), Vec2(stresses.until, 5.0));
  EXPECT_EQ(stresses.curves[1].place, "bore");
  EXPECT_EQ(stresses.curves[1].points.back(), Vec2(stresses.until, 6.0));
  plate.loads.body_forces.push_back({{}, {1.0, 0.0}, ramp(3e-6)});
  plate.loads.supports.push_back({.value = Vec2(1e-9, 0.0), .amplitude = ramp(4e-6)});
  plate.loads.thermal_loads.push_back({{}, 1.0, ramp(5e-6)});
  const Chart all = load_curve(Simulation(plate, test::numerics(), {1}));
  ASSERT_EQ(all.curves.size(), 5U);
  const char* const kinds[] = {"traction", "pressure", "body force", "support", "temperature"};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(all.curves[k].kind, kinds[k]);
    EXPECT_DOUBLE_EQ(all.curves[k].points[1].x(), static_cast<double>(k + 1) * 1e-6) << kinds[k];
    EXPECT_EQ(all.curves[k].points.back().y(), 1.0) << kinds[k];
  }
}

// Three entries, all above 0 and all different.
TEST(EnergyChart, TellsItsEntriesApart) {
  Simulation s(test::edge_crack(30e6), test::numerics(1e-3, 3e-3), {1});
  s.run(15e-6);
  const Energy ledger = energy(s);
  ASSERT_GT(ledger.broken, 0.0);
  const Chart chart = energy_chart(s);
  const double values[] = {ledger.kinetic, ledger.strain, ledger.broken};
  const char* const kinds[] = {"kinetic", "strain", "broken"};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(chart.curves[k].kind, kinds[k]);
    EXPECT_EQ(chart.curves[k].points, (Points{{s.time(), values[k]}}));
  }
  EXPECT_EQ(chart.unit, "J/m");
}

// The energy released on the way to equilibrium has its own curve, once there is any.
TEST(EnergyChart, ShowsWhatWasReleased) {
  Plate plate = test::bare_plate(20, 10);
  plate.initial_conditions.push_back(
      {{}, Vec2(0, 0), VectorField([](const Vec2& x) { return Vec2(x.y(), 0); })});
  Simulation simulation(plate, test::numerics(), {1});
  EXPECT_EQ(energy_chart(simulation).curves.size(), 3U);
  simulation.relax();
  const Chart chart = energy_chart(simulation);
  ASSERT_EQ(chart.curves.size(), 4U);
  EXPECT_EQ(chart.curves[3].kind, "released");
  EXPECT_EQ(chart.curves[3].points, (Points{{0.0, energy(simulation).released}}));
}

}  // namespace
}  // namespace hackle
