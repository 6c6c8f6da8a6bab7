// SPDX-License-Identifier: MIT
// Scenes of Hackle with cracks, holes and zones, exported as decks of LAMMPS, break the same bonds
// there.
//
// The deck is made from Hackle's own constants: those are compared with the formulas elsewhere
// (plate_test.cpp). What is new are zero-width cracks, cut by types of atoms, and full weights.
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "output/export/lammps_deck.hpp"
#include "output/export/lammps_types.hpp"
#include "peer/lammps.hpp"
#include "solver/simulation.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"
#include "support/skipping.hpp"

namespace hackle::test {
namespace {

constexpr int exported_steps = 160;  // the crack runs through most of the plate

struct ExportedCase {
  const char* name;
  Quadrature quadrature;
  double alpha;
  bool with_hole;
  double stress;   // Pa; with ramped weights so low that LAMMPS's contact forces do not act
  int min_broken;  // ends of bonds: with fewer there is too little to tell
};
void PrintTo(const ExportedCase& given, std::ostream* out) {
  *out << given.name;
}

Plate exported_plate(const ExportedCase& given) {
  Plate plate = edge_crack(given.stress);
  plate.width = 50e-3;
  plate.cracks = {Crack({0.0, 20e-3}, {20e-3, 20.3e-3})};  // oblique: lips change their rows
  plate.material.alpha = given.alpha;
  if (given.with_hole) plate.cutouts.push_back({Ellipse{{35e-3, 26e-3}, {3e-3, 3e-3}}, ""});
  return plate;
}

Numerics exported_numerics(const ExportedCase& given) {
  Numerics numerics = test::numerics(1e-3, 4e-3);
  numerics.quadrature = given.quadrature;
  numerics.breaking = Breaking::next_step;
  return numerics;
}

class ExportedDeck : public testing::TestWithParam<ExportedCase> {
 protected:
  void SetUp() override {
    HACKLE_NEEDS(lammps_is_installed(), "LAMMPS is the peer, and lmp is not on the PATH");
  }
};

// Number of bonds per node that have broken since the start.
std::vector<int> broken_since_start(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const auto born = degrees(lattice.grid, lattice.family, lattice.bonds);
  const auto left = degrees(lattice.grid, lattice.family, simulation.state().bonds);
  std::vector<int> broken;
  for (std::size_t node = 0; node < born.size(); ++node) broken.push_back(born[node] - left[node]);
  return broken;
}

TEST_P(ExportedDeck, BreaksTheSameBonds) {
  Simulation simulation(exported_plate(GetParam()), exported_numerics(GetParam()), {1});
  const Lattice& lattice = simulation.lattice();
  std::vector<std::string> notes;
  const LammpsScene scene =
      lammps_scene(simulation.plate(), simulation.numerics(), simulation.dt(), notes);
  const std::filesystem::path folder = fresh_folder();
  write_text(folder / "plate.data", lammps_data(scene));
  write_text(folder / "plate.in",
             lammps_deck(scene, {.steps = exported_steps, .every = exported_steps}, "plate.data"));
  const std::vector<PeerSample> theirs = run_deck(folder, lattice.grid);
  ASSERT_EQ(theirs.size(), 2U);
  const auto born = degrees(lattice.grid, lattice.family, lattice.bonds);
  // LAMMPS tests its bonds at the end of a step, Hackle at the start of the next.
  for (int step = 0; step <= exported_steps; ++step) simulation.step();
  const std::vector<int> ours = broken_since_start(simulation);
  int differing = 0, broken = 0;
  for (std::size_t node = 0; node < ours.size(); ++node) {
    broken += ours[node];
    differing += std::lround(theirs[1].damage[node] * born[node]) == ours[node] ? 0 : 1;
  }
  EXPECT_EQ(differing, 0);
  EXPECT_GT(broken, GetParam().min_broken);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, ExportedDeck,
    testing::Values(ExportedCase{"Full", Quadrature::full, 0.0, false, 14e6, 200},
                    ExportedCase{"FullWithHistoryAndHole", Quadrature::full, 0.25, true, 14e6, 200},
                    ExportedCase{"Ramp", Quadrature::ramp, 0.0, true, 8e6, 200}),
    [](const auto& given) { return std::string(given.param.name); });

}  // namespace
}  // namespace hackle::test
