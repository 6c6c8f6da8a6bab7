// SPDX-License-Identifier: MIT
// Two bodies are pushed into each other, in Hackle and in LAMMPS, whose short-range forces Hackle's
// contact reproduces.
//
// The lower body is shorter than the upper one and off its centre, so that they turn and slide.
// Nothing breaks, and the bodies were never joined: no bond is lost, so faces of cracks, which
// LAMMPS does not have, are not involved. The programs differ by rounding (see plate_test.cpp),
// until an impact brings bonded nodes closer than 0.9 of their distance: LAMMPS makes those repel
// each other too. This impact is too soft for that.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "peer/lammps.hpp"
#include "solver/simulation.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"
#include "support/skipping.hpp"

namespace hackle::test {
namespace {

constexpr int columns = 60, rows = 44, m = 4;
constexpr int gap_bottom = 20, gap_top = 24;  // rows without material, from edge to edge
constexpr int lower_end = 35;                 // columns of the lower body
constexpr double stress = 25e6;
constexpr int steps = 400, every = 10;  // they meet and part again

bool is_removed(int i, int j) {
  return (j >= gap_bottom && j < gap_top) || (j < gap_bottom && i >= lower_end);
}

Plate two_bodies() {
  constexpr double dx = 0.5e-3;
  Plate plate = bare_plate(columns, rows);
  plate.material.G0 = 1e9;
  plate.contact = Contact{};
  const double width = columns * dx;
  plate.cutouts.push_back({rectangle({0.0, gap_bottom * dx}, {width, gap_top * dx}), ""});
  plate.cutouts.push_back({rectangle({lower_end * dx, 0.0}, {width, gap_top * dx}), ""});
  plate.loads.tractions.push_back({Edge::top, {0.0, -stress}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, stress}});
  return plate;
}

Numerics as_lammps() {
  Numerics numerics = test::numerics();
  numerics.quadrature = Quadrature::ramp;
  numerics.constants = Constants::continuum;
  return numerics;
}

PeerPlate peer_plate(const Simulation& simulation) {
  const Material& glass = simulation.plate().material;
  const double dt = simulation.dt(), dx = 0.5e-3, horizon = m * dx;
  PeerPlate plate{simulation.lattice().grid, {}, m};
  plate.c = 9.0 * glass.E / (std::numbers::pi * std::pow(horizon, 3)) * dx * dt * dt / glass.rho;
  plate.s00 = std::sqrt(4.0 * std::numbers::pi * glass.G0 / (9.0 * glass.E * horizon));
  plate.pull = -stress / (glass.rho * dx) * dt * dt / dx;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) plate.removed.push_back(is_removed(i, j));
  return plate;
}

TEST(PeerContact, PushesAsInLammps) {
  HACKLE_NEEDS(lammps_is_installed(), "LAMMPS is the peer, and lmp is not on the PATH");
  Simulation simulation(two_bodies(), as_lammps(), {1});
  const Grid& grid = simulation.lattice().grid;
  const std::vector<PeerSample> theirs =
      run_lammps(peer_plate(simulation), steps, every, fresh_folder());
  ASSERT_EQ(theirs.size(), steps / every + 1);
  int touching = 0;
  for (const PeerSample& sample : theirs) {
    while (simulation.state().step < sample.step) simulation.step();
    touching += simulation.ledger().contact > 0.0 ? 1 : 0;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        ASSERT_LT((simulation.displacement(i, j) / grid.dx - sample.u[grid.index(i, j)]).norm(),
                  1e-11)
            << "step " << sample.step << ", node " << i << "," << j;
  }
  EXPECT_GE(touching, 4);
}

}  // namespace
}  // namespace hackle::test
