// SPDX-License-Identifier: MIT
// The faces of closed cracks: against the plate without the crack where it is pressed, against the
// plate without contact where it is pulled, slides or turns.
#include "solver/terms/crack_faces.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "measure/energy.hpp"
#include "support/mirror.hpp"
#include "support/scenes.hpp"
#include "support/states.hpp"

namespace hackle {
namespace {

// A plate of 40 by 40 nodes that never breaks, with a crack in its middle.
Plate cracked(const Vec2& from, const Vec2& to, bool contact = true) {
  Plate plate = test::bare_plate(40, 40);
  plate.no_fail.push_back(rectangle({0.0, 0.0}, {0.02, 0.02}));
  plate.cracks.push_back({from, to});
  if (contact) plate.contact = Contact{};
  return plate;
}

Plate across(bool contact = true) {
  return cracked({0.006, 0.01}, {0.014, 0.01}, contact);
}

// Of acceleration, m/s2.
double unit_of(const Simulation& simulation) {
  return simulation.lattice().grid.dx / (simulation.dt() * simulation.dt());
}

std::vector<Vec2> contacts(const Simulation& simulation) {
  std::vector<Vec2> sum(simulation.lattice().grid.nodes(), Vec2(0, 0));
  for (const LoadedNode& load : simulation.actions().forces)
    sum[simulation.lattice().grid.index(load.i, load.j)] = load.acceleration;
  return sum;
}

Simulation strained(const Plate& plate, double xx, double xy, double yy) {
  Simulation simulation(plate, test::numerics(), {1});
  simulation.restore(test::displaced(
      simulation, [&](const Vec2& x) { return Vec2(xx * x.x() + xy * x.y(), yy * x.y()); }));
  return simulation;
}

// What the upper face feels in the middle of a long crack, against what its bonds would: under a
// pressure across it and a widening by a third of the shortening, as k is made for.
TEST(CrackFaces, BearWhatBondsWould) {
  constexpr double strain = 1e-5;
  Plate whole = across();
  whole.cracks.clear();
  const auto sum = [](const Plate& plate) {
    const Simulation simulation = strained(plate, strain / 3.0, 0.0, -strain);
    const auto forces = test::accelerations(simulation);
    double total = 0.0;
    for (int j = 20; j < 30; ++j) total += forces[simulation.lattice().grid.index(20, j)].y();
    return total;
  };
  const double open = sum(across(false)), bonds = sum(whole), faces = sum(across());
  EXPECT_NEAR((faces - open) / (bonds - open), 1.0, 0.1);  // of so few directions
}

double shortening(const Plate& given, double stress, double damping = 2e5) {
  Plate plate = given;
  const Amplitude amplitude = ramp(30e-6);
  plate.loads.tractions.push_back({Edge::top, {0.0, stress}, 0.0, amplitude});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -stress}, 0.0, amplitude});
  plate.loads.damping = damping;
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(120e-6);
  return simulation.displacement(20, 39).y() - simulation.displacement(20, 0).y();
}

// Where the plate may widen, bonds that lie nearly along the crack would pull it together: 1.1 % of
// what the layer of a horizon on either side of the crack bears, and less of the whole.
TEST(CrackFaces, MakeAClosedCrackAsStiffAsThePlate) {
  Plate whole = across();
  whole.cracks.clear();
  const double right = shortening(whole, -20e6);
  EXPECT_LT(right, 0.0);
  EXPECT_LT(shortening(across(false), -20e6), 1.2 * right);
  EXPECT_NEAR(shortening(across(), -20e6), right, 0.01 * std::abs(right));
  for (const Born born : {Born::broken, Born::absent}) {
    Plate through = cracked({0.0, 0.01}, {0.02, 0.01});
    through.cracks.front().born = born;
    EXPECT_NEAR(shortening(through, -20e6), right, 0.02 * std::abs(right));
  }
}

// How far the crack gapes in the middle when the plate is pulled, at rest: waves press the ends of
// a crack before. Of one aslant a few bonds near its ends lie nearly along it, and the plate
// narrows there: a direct solution of the linear lattice with its faces gapes 8e-4 less than
// without them.
TEST(CrackFaces, DoNothingInTension) {
  const auto gape = [](const Vec2& to, bool contact) {
    Plate plate = cracked({0.006, 0.01}, to, contact);
    plate.loads.tractions.push_back({Edge::top, {0.0, 5e6}, 0.0, ramp(30e-6)});
    plate.loads.tractions.push_back({Edge::bottom, {0.0, -5e6}, 0.0, ramp(30e-6)});
    plate.loads.damping = 2e5;
    Numerics numerics = test::numerics();
    numerics.step = 50e-9;  // contacts make the default step another one
    Simulation simulation(plate, numerics, {1});
    simulation.run(90e-6);
    return simulation.displacement(20, 20).y() - simulation.displacement(20, 19).y();
  };
  const Vec2 across(0.014, 0.01), aslant(0.013, 0.013);
  EXPECT_NEAR(gape(across, true) / gape(across, false), 1.0, 1e-6);
  EXPECT_NEAR(gape(aslant, true) / gape(aslant, false), 1.0, 1.5e-3);
}

// But for the ends of the crack: nodes within a horizon of them have more bonds that lean one way
// than the other, and push nodes that are as far again.
TEST(CrackFaces, SlideFreely) {
  for (const double slip : {1e-4, 0.01, 0.09}) {
    Simulation simulation(cracked({0.0, 0.01}, {0.02, 0.01}), test::numerics(), {1});
    simulation.restore(test::displaced(
        simulation, [&](const Vec2& x) { return Vec2(x.y() > 0.0 ? slip : 0.0, 0.0); }));
    for (const LoadedNode& load : simulation.actions().forces)
      EXPECT_TRUE(load.i < 8 || load.i >= 32) << slip << ": " << load.i << "," << load.j;
  }
}

TEST(CrackFaces, TurnFreely) {
  for (const double angle : {1e-3, 0.3, 2.0}) {
    Simulation simulation(across(), test::numerics(), {1});
    const double c = std::cos(angle) - 1.0, s = std::sin(angle);
    simulation.restore(test::displaced(simulation, [&](const Vec2& x) {
      return Vec2(c * x.x() - s * x.y(), s * x.x() + c * x.y());
    }));
    EXPECT_LT(test::largest(contacts(simulation)), 1e-11 * unit_of(simulation));
  }
}

// A plate that shrinks as it cools is free of stress, with its crack as without.
TEST(CrackFaces, AreNotPressedByCooling) {
  Plate plate = across();
  plate.material.alphaT = 3.3e-6;
  plate.loads.thermal_loads.push_back({std::nullopt, -200.0, {}});
  Simulation simulation(plate, test::numerics(), {1});
  const double strain = std::sqrt(1.0 - 2.0 * 200.0 * 3.3e-6) - 1.0;
  simulation.restore(test::displaced(simulation, [&](const Vec2& x) { return Vec2(strain * x); }));
  EXPECT_LT(simulation.ledger().contact, 1e-12);
}

// Pressed from rest, all at once, and let go: what is stored in the faces comes back.
TEST(CrackFaces, KeepEnergyToSecondOrderInTheStep) {
  const auto leak = [](double dt) {
    Plate plate = across();
    plate.initial_conditions.push_back(
        {rectangle({0.0, 0.0}, {0.02, 0.01}), {{0, 0}}, {Vec2(0.0, 2.0)}});
    plate.initial_conditions.push_back(
        {rectangle({0.0, 0.01}, {0.02, 0.02}), {{0, 0}}, {Vec2(0.0, -2.0)}});
    Numerics numerics = test::numerics();
    numerics.step = dt;
    Simulation simulation(plate, numerics, {1});
    double max = 0.0, stored = 0.0;
    for (int k = 0; k < 20; ++k) {
      simulation.run(0.48e-6);
      const Energy ledger = energy(simulation);
      max = std::max(max, std::abs(ledger.residual()) / ledger.external);
      stored = std::max(stored, ledger.contact / ledger.external);
    }
    EXPECT_GT(stored, 0.01);
    return max;
  };
  EXPECT_GT(leak(60e-9) / leak(30e-9), 3.0);
}

// Slow loading takes no notice of them, and what they then store counts as nothing; in the run that
// follows they push the plate apart, and the ledger closes.
TEST(CrackFaces, AreNotSeenBySlowLoading) {
  Plate plate = across();
  plate.loads.tractions.push_back({Edge::top, {0.0, -20e6}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, 20e6}});
  Numerics numerics = test::numerics();
  numerics.step = 20e-9;  // it begins with a blow
  Simulation simulation(plate, numerics, {1}), open(across(false), numerics, {1});
  open.set_loads(plate.loads);
  simulation.relax();
  open.relax();
  EXPECT_NEAR(simulation.displacement(20, 39).y() / open.displacement(20, 39).y(), 1.0, 1e-5);
  const double work = simulation.ledger().external;
  EXPECT_LT(std::abs(simulation.ledger().contact), 1e-9 * work);
  simulation.run(10e-6);
  const Energy ledger = energy(simulation);
  EXPECT_LT(ledger.contact, -1e-3 * work);
  EXPECT_GT(ledger.kinetic, 0.0);
  EXPECT_LT(std::abs(ledger.residual()), 2e-3 * std::abs(ledger.contact));
}

// Faces that a start presses hold energy from the start.
TEST(CrackFaces, StartWithWhatIsStoredInThem) {
  Plate plate = across();
  plate.initial_conditions.push_back(
      {rectangle({0.0, 0.01}, {0.02, 0.02}), {Vec2(0.0, -1e-6)}, {{0, 0}}});
  Simulation simulation(plate, test::numerics(), {1});
  const Energy before = energy(simulation);
  EXPECT_GT(before.contact, 0.01 * before.external);
  EXPECT_LT(std::abs(before.residual()), 1e-9 * before.external);
}

// A crack aslant under a pressure that breaks the plate around its ends: what its faces stored
// there and store no more is counted.
TEST(CrackFaces, KeepTheLedgerWhileBondsBreak) {
  Plate plate = cracked({0.006, 0.008}, {0.014, 0.012});
  plate.no_fail = {strip(plate, Edge::top, 2e-3), strip(plate, Edge::bottom, 2e-3)};
  plate.loads.tractions.push_back({Edge::top, {0.0, -400e6}, 0.0, ramp(2e-6)});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, 400e6}, 0.0, ramp(2e-6)});
  Simulation simulation(plate, test::numerics(), {1});
  simulation.run(12e-6);
  EXPECT_GT(count_damage(simulation).broken_bonds, 100);
  const Energy ledger = energy(simulation);
  const double unit = 2235.0 * std::pow(0.5e-3, 4) / (simulation.dt() * simulation.dt());
  const double lost = simulation.state().contact_lost * unit;
  EXPECT_GT(std::abs(lost), 1e-3 * ledger.external);
  EXPECT_LT(std::abs(ledger.residual()), 0.3 * std::abs(lost));
}

TEST(CrackFaces, KeepMirrorImagesAndBits) {
  const auto solved = [](int threads, Precision precision) {
    Plate plate = across();
    plate.loads.tractions.push_back({Edge::top, {0.0, -20e6}});
    plate.loads.tractions.push_back({Edge::bottom, {0.0, 20e6}});
    Numerics numerics = test::numerics();
    numerics.precision = precision;
    Simulation simulation(plate, numerics, {threads});
    simulation.run(15e-6);
    return simulation;
  };
  for (const Precision precision : {Precision::f64, Precision::f32}) {
    const Simulation one = solved(1, precision);
    EXPECT_GT(one.ledger().contact, 0.0);
    EXPECT_EQ(test::asymmetric_nodes(one, true), 0);
    EXPECT_EQ(test::asymmetric_nodes(one, false), 0);
    EXPECT_EQ(solved(3, precision).state().hash(), one.state().hash());
  }
}

}  // namespace
}  // namespace hackle
