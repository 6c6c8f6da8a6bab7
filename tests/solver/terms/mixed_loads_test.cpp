// SPDX-License-Identifier: MIT
// Loads, supports, starts and damping on every material of a plate at once, against Newton's second
// law and sums over nodes, whose densities follow from their places.
#include <cmath>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "scene/notch.hpp"
#include "solver/simulation.hpp"
#include "support/composite.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

constexpr int nx = 60, ny = 30;
constexpr double dx = 0.5e-3, width = nx * dx, height = ny * dx;  // 30 x 15 mm

// Resin on the left, steel on the right, glass between them, all from edge to edge; a bore in steel
// and a slot that opens to the top in glass.
double density(int i, int j) {
  const Vec2 at = dx * Vec2(i + 0.5, j + 0.5);
  if ((at - Vec2(25e-3, 7e-3)).norm() < 2e-3) return 0.0;
  if (std::abs(at.x() - 15e-3) < 1e-3 && at.y() > 11e-3) return 0.0;
  return at.x() < 9e-3 ? 1200.0 : at.x() > 20e-3 ? 7850.0 : 2235.0;
}

Plate three_materials() {
  Plate plate = test::bare_plate(nx, ny);
  Material soft = test::resin(), stiff = test::steel();
  plate.inclusions.push_back({rectangle({0, 0}, {9e-3, height}), soft});
  plate.inclusions.push_back({rectangle({20e-3, 0}, {width, height}), stiff});
  plate.cutouts.push_back({Ellipse{{25e-3, 7e-3}, {2e-3, 2e-3}, 0.0}, "bore"});
  plate.cutouts.push_back(
      {shape_of({{15e-3, height}, 4e-3, 2e-3, Notch::Kind::slot, 0.0}, plate), "slot"});
  return plate;
}

Simulation simulate(const Plate& plate) {
  return Simulation(plate, test::numerics(dx, 3 * dx), {1});
}

// Of `of(rho, v)` over the nodes, times the area of each.
template <class Of>
auto sum_over_nodes(const Simulation& simulation, Of of) {
  const std::vector<Vec2> velocities = simulation.velocities();
  decltype(of(1.0, Vec2(0, 0))) sum = of(0.0, Vec2(0, 0));
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      sum += dx * dx * of(density(i, j), velocities[static_cast<std::size_t>(j * nx + i)]);
  return sum;
}

Vec2 momentum(const Simulation& simulation) {
  return sum_over_nodes(simulation, [](double rho, const Vec2& v) -> Vec2 { return rho * v; });
}
double kinetic(const Simulation& simulation) {
  return sum_over_nodes(simulation,
                        [](double rho, const Vec2& v) { return 0.5 * rho * v.squaredNorm(); });
}
double area_of_material() {
  double area = 0.0;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) area += density(i, j) > 0.0 ? dx * dx : 0.0;
  return area;
}

// A load by itself and the force, N/m, that it is.
struct Load {
  const char* name;
  void (*add)(Loads&);
  Vec2 (*force)();
};

class ConstantLoad : public testing::TestWithParam<Load> {};

// Bonds push their ends alike, so force times time is all the momentum there is.
TEST_P(ConstantLoad, GivesItsImpulse) {
  Plate plate = three_materials();
  GetParam().add(plate.loads);
  Simulation simulation = simulate(plate);
  simulation.run(5e-6);
  const Vec2 wanted = simulation.time() * GetParam().force();
  EXPECT_NEAR((momentum(simulation) - wanted).norm(), 0.0, 1e-9 * wanted.norm()) << GetParam().name;
  const Energy ledger = energy(simulation);
  EXPECT_NEAR(ledger.kinetic, kinetic(simulation), 1e-12 * ledger.kinetic);
  EXPECT_GT(ledger.external, 0.0);
  // A sudden load makes waves as short as the lattice has, which the step resolves to some percent.
  EXPECT_NEAR(ledger.residual(), 0.0, 0.03 * ledger.external) << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ConstantLoad,
    testing::Values(
        Load{"top",
             [](Loads& l) {
               l.tractions.push_back({Edge::top, {1e5, 2e5}});
             },
             []() -> Vec2 { return Vec2(1e5, 2e5) * (width - 2e-3); }},
        Load{"bottom",
             [](Loads& l) {
               l.tractions.push_back({Edge::bottom, {1e5, -2e5}});
             },
             []() -> Vec2 { return Vec2(1e5, -2e5) * width; }},
        Load{"left",
             [](Loads& l) {
               l.tractions.push_back({Edge::left, {-1e5, 3e5}});
             },
             []() -> Vec2 { return Vec2(-1e5, 3e5) * height; }},
        Load{"right",
             [](Loads& l) {
               l.tractions.push_back({Edge::right, {1e5, 3e5}, 2e-3, {}});
             },
             []() -> Vec2 { return Vec2(1e5, 3e5) * height; }},
        Load{"two on an edge",
             [](Loads& l) {
               l.tractions.push_back({Edge::bottom, {1e5, 0}});
               l.tractions.push_back({Edge::bottom, {2e5, -1e5}, 1.5e-3, {}});
             },
             []() -> Vec2 { return Vec2(3e5, -1e5) * width; }},
        Load{"slot",
             [](Loads& l) {
               l.pressures.push_back({"slot", 4e5, {}});
             },
             []() -> Vec2 { return Vec2(0, -4e5) * 2e-3; }},
        Load{"both rims",
             [](Loads& l) {
               l.pressures.push_back({"bore", 1e5, {}});
               l.pressures.push_back({"slot", 1e5, {}});
               l.pressures.push_back({"slot", 2e5, {}});
             },
             []() -> Vec2 { return Vec2(0, -3e5) * 2e-3; }},
        Load{"body",
             [](Loads& l) {
               l.body_forces.push_back({{}, {2e7, -1e7}, {}});
             },
             []() -> Vec2 { return Vec2(2e7, -1e7) * area_of_material(); }},
        Load{"two bodies",
             [](Loads& l) {
               l.body_forces.push_back({{}, {2e7, -1e7}, {}});
               l.body_forces.push_back({rectangle({0, 0}, {5e-3, height}), {0, 5e7}, {}});
             },
             []() -> Vec2 {
               return Vec2(2e7, -1e7) * area_of_material() + Vec2(0, 5e7) * 5e-3 * height;
             }}));

// Two that act on the same nodes, each with an amplitude of its own: half of the triangle under a
// ramp, and a pulse.
TEST(Loads, OfOneKindKeepTheirOwnAmplitudes) {
  Plate plate = three_materials();
  plate.loads.tractions.push_back({Edge::bottom, {1e5, 0}, 0.0, ramp(4e-6)});
  plate.loads.tractions.push_back({Edge::bottom, {0, -2e5}, 0.0, pulse(1e-6, 1e-6)});
  Numerics numerics = test::numerics(dx, 3 * dx);
  numerics.step = 20e-9;
  Simulation simulation(plate, numerics, {1});
  simulation.run(4e-6);
  // Impulses are sums over steps of 20 ns: of the ramp exact, of the pulse to one step.
  EXPECT_NEAR(momentum(simulation).x(), 1e5 * width * 2e-6, 1e-3 * 1e5 * width * 2e-6);
  EXPECT_NEAR(momentum(simulation).y(), -2e5 * width * 1e-6, 2e5 * width * 21e-9);
}

Support prescribed(const Shape& region, Support::Kind kind, const Vec2& value,
                   Amplitude amplitude) {
  Support support;
  support.region = region;
  support.kind = kind;
  support.value = value;
  support.amplitude = std::move(amplitude);
  return support;
}

// On resin, on steel, on the border of steel and glass, by displacement and by velocity, along one
// axis and both: what they put in is found again.
TEST(Supports, OnEveryMaterialDoTheWorkThatThePlateReceives) {
  const Shape places[] = {rectangle({0, 0}, {1e-3, height}), rectangle({29e-3, 0}, {width, height}),
                          rectangle({19e-3, 0}, {21e-3, 1e-3})};
  for (const Shape& place : places)
    for (const Support::Kind kind : {Support::Kind::displacement, Support::Kind::velocity})
      for (const int axes : {1, 2, 3}) {
        Plate plate = three_materials();
        const bool velocity = kind == Support::Kind::velocity;
        const Vec2 value = velocity ? Vec2(0.3, 0.2) : Vec2(1e-6, 2e-6);
        // Smooth, as the resin's waves are slow: a sine from rest to rest.
        const Amplitude amplitude(
            [velocity](double t) {
              const double phase = std::min(t / 6e-6, 1.0) * 3.141592653589793;
              return velocity ? std::sin(phase) : 0.5 - 0.5 * std::cos(phase);
            },
            "wave");
        Support support = prescribed(place, kind, value, amplitude);
        support.along_x = axes != 2;
        support.along_y = axes != 1;
        plate.loads.supports.push_back(support);
        Numerics numerics = test::numerics(dx, 3 * dx);
        numerics.step = 20e-9;
        Simulation simulation(plate, numerics, {1});
        simulation.run(5e-6);
        const Energy ledger = energy(simulation);
        EXPECT_GT(ledger.external, 0.0);
        EXPECT_NEAR(ledger.external, kinetic(simulation) + ledger.strain, 5e-3 * ledger.external)
            << axes << ' ' << velocity;
      }
}

// Where two hold a node, the last one does, along its own axis alone.
TEST(Supports, OfWhichTwoHoldANodeTheLastOneDoesAlongItsAxis) {
  Plate plate = three_materials();
  const Shape all = rectangle({0, 0}, {4e-3, height}), part = rectangle({0, 0}, {4e-3, 5e-3});
  plate.loads.supports = {prescribed(all, Support::Kind::displacement, {1e-6, 2e-6}, ramp(1e-6)),
                          prescribed(part, Support::Kind::displacement, {3e-6, 4e-6}, ramp(1e-6))};
  plate.loads.supports.back().along_y = false;
  Simulation simulation = simulate(plate);
  simulation.run(2e-6);
  EXPECT_NEAR(simulation.displacement(3, 3).x(), 3e-6, 1e-18);
  EXPECT_NEAR(simulation.displacement(3, 3).y(), 2e-6, 1e-18);
  EXPECT_NEAR(simulation.displacement(3, 20).x(), 1e-6, 1e-18);
  EXPECT_NEAR(simulation.displacement(3, 20).y(), 2e-6, 1e-18);
}

TEST(Supports, FollowTheirAmplitudeAtItsOwnMoment) {
  Plate plate = three_materials();
  const Shape left = rectangle({0, 0}, {2e-3, height}),
              right = rectangle({27e-3, 0}, {width, height});
  plate.loads.supports = {prescribed(left, Support::Kind::displacement, {1e-6, 0}, ramp(3e-6)),
                          prescribed(right, Support::Kind::velocity, {0.5, 0}, ramp(3e-6))};
  Simulation simulation = simulate(plate);
  for (int step = 1; step <= 20; ++step) {
    simulation.step();
    const double t = simulation.time();
    EXPECT_NEAR(simulation.displacement(1, 9).x(), 1e-6 * std::min(t / 3e-6, 1.0), 1e-18);
    if (t <= 3e-6) {  // the midpoint rule is exact for a straight line
      EXPECT_NEAR(simulation.displacement(58, 9).x(), 0.5 * 0.5 * t * t / 3e-6, 1e-18);
    }
  }
}

// In single precision what the whole plate has moved is taken out of u now and then; a support
// counts it in.
TEST(Supports, KnowHowFarThePlateHasFlown) {
  Plate plate = test::bare_plate(20, 10);
  plate.initial_conditions.push_back({{}, Vec2(0, 0), Vec2(300.0, -200.0)});
  const Amplitude flight([](double t) { return t; }, "flight");
  plate.loads.supports = {prescribed(rectangle({0, 0}, {1e-3, 5e-3}), Support::Kind::displacement,
                                     {300.0, -200.0}, flight)};
  Numerics numerics = test::numerics();
  numerics.precision = Precision::f32;
  Simulation simulation(plate, numerics, {1});
  simulation.run(60e-6);
  EXPECT_GT(simulation.state().origin.norm(), 1.0);
  // Of 36 spacings a float holds 4e-6 spacings.
  for (const int i : {0, 1, 19}) {
    const Vec2 wanted = simulation.time() * Vec2(300.0, -200.0);
    EXPECT_NEAR((simulation.displacement(i, 4) - wanted).norm(), 0.0, 1e-8) << i;
  }
}

TEST(InitialCondition, GivesEveryMaterialItsMotion) {
  Plate plate = three_materials();
  plate.initial_conditions.push_back({{}, Vec2(0, 0), Vec2(3.0, -1.0)});
  plate.initial_conditions.push_back(
      {rectangle({0, 0}, {15e-3, height}), Vec2(2e-8, -1e-8), Vec2(0.0, 3.0)});
  const Simulation simulation = simulate(plate);
  double wanted = 0.0;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      wanted += 0.5 * density(i, j) * dx * dx * (9.0 + (i < 30 ? 4.0 : 1.0));
  const Energy ledger = energy(simulation);
  EXPECT_NEAR(ledger.kinetic, wanted, 1e-12 * wanted);
  EXPECT_NEAR(simulation.displacement(3, 3).x(), 2e-8, 1e-20);
  EXPECT_NEAR(simulation.displacement(3, 3).y(), -1e-8, 1e-20);
  EXPECT_EQ(simulation.displacement(40, 3), Vec2(0, 0));
  EXPECT_NEAR(simulation.velocities()[3 * nx + 3].y(), 2.0, 1e-12);
  EXPECT_NEAR(simulation.velocities()[3 * nx + 40].y(), -1.0, 1e-12);
  EXPECT_NEAR(ledger.residual(), 0.0, 1e-12 * ledger.external);
}

TEST(Damping, TakesTheEnergyOfEveryMaterial) {
  Plate plate = three_materials();
  plate.loads.damping = 1e5;
  plate.initial_conditions.push_back({{}, Vec2(0, 0), Vec2(1.0, -2.0)});
  Simulation simulation = simulate(plate);
  const double before = kinetic(simulation);
  simulation.run(5e-6);
  const double factor = std::exp(-1e5 * simulation.time());
  const Energy ledger = energy(simulation);
  EXPECT_NEAR(kinetic(simulation), before * factor * factor, 1e-9 * before);
  EXPECT_NEAR(ledger.damped, before - kinetic(simulation), 1e-9 * before);
}

// In lattice units of several materials and precisions: all at rest stays at rest, a plate that
// moves as a whole goes on.
TEST(MixedPlate, MovesAsAWholeWithoutForce) {
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    Plate plate = three_materials();
    plate.initial_conditions.push_back({{}, Vec2(0, 0), Vec2(2.0, -1.0)});
    Numerics numerics = test::numerics(dx, 3 * dx);
    numerics.precision = precision;
    Simulation simulation(plate, numerics, {1});
    simulation.run(10e-6);
    const double slack = precision == Precision::f64 ? 1e-15 : 1e-10;
    for (const int i : {3, 17, 31, 57}) {
      EXPECT_NEAR(simulation.displacement(i, 4).x(), 2.0 * simulation.time(), slack);
      EXPECT_NEAR(simulation.displacement(i, 4).y(), -simulation.time(), slack);
    }
  }
}

}  // namespace
}  // namespace hackle
