// SPDX-License-Identifier: MIT
// Gauges and fields between nodes, on plates whose displacement is known.
#include "measure/gauge.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "measure/between_nodes.hpp"
#include "measure/node_value.hpp"
#include "measure/node_values.hpp"
#include "measure/scalar.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

// ux = 1e-5 x + 2e-5 y, uy = -3e-5 x + 4e-5 y, but what lies above the middle is moved up by a
// `gap`, m.
Simulation strained(Plate plate, double gap = 0.0) {
  const double middle = 0.5 * plate.height;
  plate.initial_conditions.push_back({{},
                                      VectorField([=](const Vec2& x) {
                                        return Vec2(1e-5 * x.x() + 2e-5 * x.y(),
                                                    -3e-5 * x.x() + 4e-5 * x.y() +
                                                        (x.y() > middle ? gap : 0.0));
                                      }),
                                      {}});
  return Simulation(plate, test::numerics(), {1});
}

Gauge gauge_between(Gauge::Kind kind, const Vec2& from, const Vec2& to) {
  Gauge gauge;
  gauge.kind = kind;
  gauge.from = from;
  gauge.to = to;
  return gauge;
}

double read_point(const View& view, const std::string& of, const Vec2& place) {
  Gauge gauge;
  gauge.of = of;
  gauge.from = place;
  return reading(gauge, view).value();
}

// Also in the outermost half spacing.
TEST(Gauge, APointReadsALinearFieldExactly) {
  const Simulation simulation = strained(test::bare_plate(40, 20));
  for (const Vec2& place : {Vec2(0.0, 0.0), Vec2(3.1e-3, 4.7e-3), Vec2(20e-3, 10e-3)}) {
    EXPECT_NEAR(read_point(simulation, "ux", place), 1e-5 * place.x() + 2e-5 * place.y(), 1e-18);
    EXPECT_NEAR(read_point(simulation, "uy", place), -3e-5 * place.x() + 4e-5 * place.y(), 1e-18);
    EXPECT_NEAR(read_point(simulation, "strain_xx", place), 1e-5, 1e-12);
    EXPECT_NEAR(read_point(simulation, "strain_yy", place), 4e-5, 1e-12);
    EXPECT_NEAR(read_point(simulation, "strain_xy", place), -0.5e-5, 1e-12);
  }
  // Two horizons inside all bonds are there: Hooke's law with the moduli of the lattice.
  const Moduli& moduli = simulation.lattice().calibration.moduli;
  EXPECT_NEAR(read_point(simulation, "stress_xx", {10e-3, 5e-3}),
              moduli.C11 * 1e-5 + moduli.C12 * 4e-5, 1e-3 * moduli.C11 * 1e-5);
}

TEST(Gauge, LinesAndRegionsReadMeans) {
  const Simulation simulation = strained(test::bare_plate(40, 20));
  Gauge line = gauge_between(Gauge::Kind::line, {1e-3, 2e-3}, {9e-3, 2e-3});
  line.of = "ux";
  EXPECT_NEAR(reading(line, simulation).value(), 1e-5 * 5e-3 + 2e-5 * 2e-3, 1e-17);
  Gauge region = gauge_between(Gauge::Kind::region, {}, {});
  region.area = Ellipse{{10e-3, 5e-3}, {2e-3, 2e-3}, 0.0};
  region.of = "uy";
  EXPECT_NEAR(reading(region, simulation).value(), -3e-5 * 10e-3 + 4e-5 * 5e-3, 1e-17);
}

TEST(Gauge, ExtensometersReadTheChangeOfDistance) {
  const Simulation simulation = strained(test::bare_plate(40, 20));
  const Vec2 from(2e-3, 3e-3), to(12e-3, 8e-3), line = to - from;
  const Vec2 moved(1e-5 * line.x() + 2e-5 * line.y(), -3e-5 * line.x() + 4e-5 * line.y());
  const double grown = (line + moved).norm() - line.norm();
  EXPECT_NEAR(reading(gauge_between(Gauge::Kind::extension, from, to), simulation).value(), grown,
              1e-16);
  EXPECT_NEAR(reading(gauge_between(Gauge::Kind::strain, from, to), simulation).value(),
              grown / line.norm(), 1e-13);
}

// A plate that is cut through: its upper half went up by a micrometre, and no value mixes both.
TEST(Gauge, NoneReadsAcrossAnOpenCrack) {
  Plate plate = test::bare_plate(40, 20);
  plate.cracks.push_back({{0.0, 5e-3}, {20e-3, 5e-3}, Born::broken});
  const double gap = 1e-6;
  const Simulation simulation = strained(plate, gap);
  const auto uy = [](const Vec2& place) { return -3e-5 * place.x() + 4e-5 * place.y(); };
  const Vec2 below(7.3e-3, 4.9e-3), above(7.3e-3, 5.1e-3);
  // Held at the last row of its side, a quarter of a spacing from it: no further than this.
  const double held = 4e-5 * 0.25e-3;
  EXPECT_NEAR(read_point(simulation, "uy", below), uy(below), held);
  EXPECT_NEAR(read_point(simulation, "uy", above), uy(above) + gap, held);
  // From row to row, with the strain between them.
  EXPECT_NEAR(reading(gauge_between(Gauge::Kind::opening, below, above), simulation).value(),
              gap + 4e-5 * 0.5e-3, 1e-16);
  EXPECT_NEAR(reading(gauge_between(Gauge::Kind::sliding, below, above), simulation).value(), 0.0,
              2.0 * held);
  EXPECT_NEAR(read_point(simulation, "strain_yy", below), 4e-5, 1e-10);
  const NodeValues values("displacement_y", simulation);
  EXPECT_NEAR(values.at(below).value(), read_point(simulation, "uy", below), 1e-12);
  EXPECT_NEAR(values.at(above).value(), read_point(simulation, "uy", above), 1e-12);
}

TEST(Gauge, OffThePlateAndInHolesItReadsNothing) {
  Plate plate = test::bare_plate(40, 20);
  plate.cutouts.push_back({Ellipse{{10e-3, 5e-3}, {2e-3, 2e-3}, 0.0}});
  const Simulation simulation = strained(plate);
  Gauge gauge;
  for (const Vec2& place : {Vec2(-1e-3, 1e-3), Vec2(21e-3, 1e-3), Vec2(10e-3, 5e-3)}) {
    gauge.from = place;
    EXPECT_FALSE(reading(gauge, simulation));
    EXPECT_FALSE(NodeValues("damage", simulation).at(place));
    EXPECT_THROW(check_on(gauge, simulation, "read"), Error);
  }
  gauge.from = {10e-3, 7.6e-3};  // beside the hole
  EXPECT_TRUE(reading(gauge, simulation));
}

TEST(NodeValues, KnowExtremesAndMeansOfTheirMoment) {
  Simulation simulation = strained(test::bare_plate(40, 20));
  const NodeValues values("displacement_x", simulation);
  simulation.run(5e-6);
  EXPECT_EQ(values.time(), 0.0);
  const double last = 20e-3 - 0.25e-3, top = 10e-3 - 0.25e-3;
  EXPECT_NEAR(values.max().value, 1e-5 * last + 2e-5 * top, 1e-13);
  EXPECT_LT((values.max().place - Vec2(last, top)).norm(), 1e-12);
  EXPECT_LT((values.min().place - Vec2(0.25e-3, 0.25e-3)).norm(), 1e-12);
  EXPECT_NEAR(values.mean().value(), 1e-5 * 10e-3 + 2e-5 * 5e-3, 1e-13);
  EXPECT_NEAR(values.mean(rectangle({0.0, 0.0}, {1e-3, 1e-3})).value(), 3e-5 * 0.5e-3, 1e-14);
  EXPECT_FALSE(values.mean(rectangle({0.0, 0.0}, {0.1e-3, 0.1e-3})));
}

TEST(NodeQuantity, NamesGoWithTheirRows) {
  ASSERT_EQ(node_quantities().size(), node_quantity_names.size());
  for (std::size_t k = 0; k < node_quantity_names.size(); ++k)
    EXPECT_EQ(node_quantities()[k].name, node_quantity_names[k]);
}

}  // namespace
}  // namespace hackle
