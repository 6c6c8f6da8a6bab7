// SPDX-License-Identifier: MIT
// A crack runs from a slot past a hole, in Hackle and in LAMMPS (`pair_style peri/pmb`).
//
// Both programs can describe this scene: LAMMPS has no cracks and no no-fail zones (its s0 per node
// lets a strong type protect its weak neighbours, LAMMPS issue 984). So the crack starts from a
// slot of removed nodes, and the load is low enough for the loaded rows to hold. The slot is m rows
// high: across a lower one bonds would reach from lip to lip.
//
// Both programs integrate with velocity Verlet but round differently: LAMMPS stores positions, not
// displacements, and a position of 60 dx has an ulp of 7e-15 dx. The remaining difference is some
// 1e-12 of the displacements, until bodies touch: LAMMPS cannot run without contact forces, which
// have a test of their own.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "peer/lammps.hpp"
#include "peer/reference.hpp"
#include "solver/simulation.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"
#include "support/skipping.hpp"

namespace hackle::test {
namespace {

constexpr int columns = 120, rows = 80, m = 4;
constexpr int slot_end = 40, slot_bottom = 38, slot_top = 42;  // first column, row past it
constexpr int steps = 240, every = 10;                         // 51 us; LAMMPS takes 3 s

// A case to solve. At 6 MPa the crack runs straight, at 8 MPa it forks.
struct Case {
  const char* name;
  double stress;  // Pa
  double alpha;
  bool straight;
};
void PrintTo(const Case& given, std::ostream* out) {
  *out << given.name;
}
constexpr Case cases[] = {{"Straight", 6e6, 0.0, true},
                          {"StraightWithHistory", 6e6, 0.25, true},
                          {"Fork", 8e6, 0.0, false}};

bool is_removed(const Grid& grid, int i, int j) {
  const bool in_slot = i < slot_end && j >= slot_bottom && j < slot_top;
  return in_slot || (grid.position(i, j) - Vec2(42e-3, 30e-3)).norm() < 3e-3;
}

Simulation hackle_plate(const Case& given) {
  Plate plate = bare_plate(columns, rows);
  plate.loads.tractions.push_back({Edge::top, {0.0, given.stress}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -given.stress}});
  plate.material.alpha = given.alpha;
  Numerics numerics = test::numerics();
  numerics.quadrature = Quadrature::ramp;
  numerics.constants = Constants::continuum;
  numerics.breaking = Breaking::next_step;
  numerics.step = 212e-9;  // the paths of the cases are known for this one
  Simulation simulation(plate, numerics, {1});
  const Lattice& lattice = simulation.lattice();
  State state = simulation.state();
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      if (is_removed(lattice.grid, i, j)) isolate(lattice.grid, lattice.family, i, j, state.bonds);
  simulation.restore(state);
  return simulation;
}

// Makes the same plate in lattice units, from the formulas and not from Hackle's tables.
PeerPlate peer_plate(const Simulation& simulation, const Case& given) {
  const Material glass = duran50();
  const double dt = simulation.dt();
  PeerPlate plate{simulation.lattice().grid, {}, m};
  const double dx = plate.grid.dx, horizon = m * dx;
  const double c = 9.0 * glass.E / (std::numbers::pi * std::pow(horizon, 3));
  plate.c = c * dx * dt * dt / glass.rho;
  plate.s00 = std::sqrt(4.0 * std::numbers::pi * glass.G0 / (9.0 * glass.E * horizon));
  plate.alpha = given.alpha;
  plate.pull = given.stress / (glass.rho * dx) * dt * dt / dx;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) plate.removed.push_back(is_removed(plate.grid, i, j));
  return plate;
}

// Number of intact bonds per node, and displacements in dx.
struct Snapshot {
  std::vector<int> bonds;
  std::vector<Vec2> u;
};

template <class Holds, class Displacement>
Snapshot look(const Holds& holds, const Displacement& displacement) {
  const Family family(m, Quadrature::ramp);
  Snapshot snapshot;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      int count = 0;
      family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
        count += (holds(i, j, a, b) ? 1 : 0) + (holds(i, j, -a, -b) ? 1 : 0);
      });
      snapshot.bonds.push_back(count);
      snapshot.u.push_back(displacement(i, j));
    }
  return snapshot;
}

// LAMMPS tests its bonds at the end of a step, Hackle at the start of the next.
Snapshot look(const Simulation& simulation) {
  const double dx = simulation.lattice().grid.dx;
  Simulation next = simulation;
  next.step();
  return look([&](int i, int j, int a, int b) { return next.holds(i, j, a, b); },
              [&](int i, int j) { return Vec2(simulation.displacement(i, j) / dx); });
}

Snapshot look(const Reference& reference) {
  return look([&](int i, int j, int a, int b) { return reference.holds(i, j, a, b); },
              [&](int i, int j) { return reference.displacement(i, j); });
}

template <class Engine>
std::vector<Snapshot> solve(Engine engine, int last_step) {
  std::vector<Snapshot> snapshots{look(engine)};
  for (int step = 1; step <= last_step; ++step) {
    engine.step();
    if (step % every == 0) snapshots.push_back(look(engine));
  }
  return snapshots;
}

// Counts nodes whose number of bonds differs from LAMMPS's. Its damage is broken bonds over initial
// bonds, since all volumes are 1.
int differing_nodes(const Snapshot& ours, const Snapshot& start, const PeerSample& theirs) {
  int count = 0;
  for (std::size_t node = 0; node < ours.bonds.size(); ++node) {
    const int born = start.bonds[node];
    count += born - std::lround(theirs.damage[node] * born) == ours.bonds[node] ? 0 : 1;
  }
  return count;
}

// Returns the largest difference of displacements over the largest displacement.
double difference(const Snapshot& ours, const PeerSample& theirs) {
  double worst = 0.0, largest = 0.0;
  for (std::size_t node = 0; node < ours.u.size(); ++node) {
    if (ours.bonds[node] == 0) continue;  // removed: Hackle moves such nodes, LAMMPS has none
    worst = std::max(worst, (ours.u[node] - theirs.u[node]).norm());
    largest = std::max(largest, theirs.u[node].norm());
  }
  return largest > 0.0 ? worst / largest : worst;
}

bool is_whole(const Snapshot& now, const Snapshot& start) {
  return now.bonds == start.bonds;
}

// Returns the length of the crack, m, from the end of the slot; 0 if it leaves the rows in front of
// the slot.
double straight_crack(const Snapshot& now, const Snapshot& start, const Grid& grid) {
  int tip = slot_end;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::size_t node = grid.index(i, j);
      if (now.bonds[node] >= 0.65 * start.bonds[node]) continue;
      if (j < slot_bottom - 2 || j >= slot_top + 2) return 0.0;
      tip = std::max(tip, i + 1);
    }
  return (tip - slot_end) * grid.dx;
}

// Returns whether LAMMPS's contact forces act: on two nodes closer than 0.9 of their initial
// distance, and closer than 1.35 dx. At rest and in tension they do not.
bool is_touching(const PeerPlate& plate, const PeerSample& sample) {
  const Family family(m, Quadrature::ramp);
  bool touching = false;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      family.for_each_bond([&](int a, int b, const Vec2&, double, int) {
        if (!plate.grid.contains(i + a, j + b)) return;
        const std::size_t one = plate.grid.index(i, j), other = plate.grid.index(i + a, j + b);
        if (plate.removed[one] || plate.removed[other]) return;
        const Vec2 xi(a, b);
        const double distance = (xi + sample.u[other] - sample.u[one]).norm();
        touching = touching || distance < std::min(0.9 * xi.norm(), 1.35);
      });
  return touching;
}

class PeerTest : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    HACKLE_NEEDS(lammps_is_installed(), "LAMMPS is the peer, and lmp is not on the PATH");
  }

  std::vector<PeerSample> solve_with_lammps(int last_step) const {
    return run_lammps(peer_, last_step, every, fresh_folder());
  }

  void expect_the_crack(const std::vector<Snapshot>& ours) const {
    const double length = straight_crack(ours.back(), ours.front(), peer_.grid);
    EXPECT_EQ(length >= 10e-3, GetParam().straight) << length;
  }

  Simulation simulation_ = hackle_plate(GetParam());
  PeerPlate peer_ = peer_plate(simulation_, GetParam());
};

// Expects equal displacements at every sample and equal broken bonds at every node.
void expect_same(const std::vector<Snapshot>& ours, const std::vector<PeerSample>& theirs) {
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t k = 0; k < ours.size(); ++k) {
    SCOPED_TRACE(testing::Message() << "step " << theirs[k].step);
    EXPECT_LT(difference(ours[k], theirs[k]), 1e-9);
    EXPECT_EQ(differing_nodes(ours[k], ours.front(), theirs[k]), 0);
  }
}

TEST_P(PeerTest, NodesMoveAsInLammpsUntilTheFirstBondBreaks) {
  constexpr int last_step = 100;
  const std::vector<Snapshot> ours = solve(simulation_, last_step);
  const std::vector<PeerSample> theirs = solve_with_lammps(last_step);
  ASSERT_EQ(ours.size(), theirs.size());
  std::size_t whole = 0;
  for (std::size_t k = 0; k < ours.size() && is_whole(ours[k], ours.front()); ++k, ++whole) {
    EXPECT_LT(difference(ours[k], theirs[k]), 1e-9) << "step " << theirs[k].step;
    EXPECT_EQ(differing_nodes(ours[k], ours.front(), theirs[k]), 0);
  }
  EXPECT_GE(whole, 5U);
  EXPECT_LT(whole, ours.size()) << "no bond breaks, the load is too low to tell";
}

TEST_P(PeerTest, ACrackBreaksTheBondsThatItBreaksInLammps) {
  const std::vector<Snapshot> ours = solve(simulation_, steps);
  expect_same(ours, solve_with_lammps(steps));
  expect_the_crack(ours);
}

// Confirms our understanding of LAMMPS: a hundred plain lines give the same results.
TEST_P(PeerTest, ThePlainRulesGiveWhatLammpsGives) {
  const std::vector<Snapshot> ours = solve(Reference(peer_), steps);
  const std::vector<PeerSample> theirs = solve_with_lammps(steps);
  expect_same(ours, theirs);
  expect_the_crack(ours);
  for (const PeerSample& sample : theirs) EXPECT_FALSE(is_touching(peer_, sample)) << sample.step;
}

INSTANTIATE_TEST_SUITE_P(Plate, PeerTest, testing::ValuesIn(cases),
                         [](const auto& given) { return std::string(given.param.name); });

}  // namespace
}  // namespace hackle::test
