// SPDX-License-Identifier: MIT
#include "output/export/lammps_deck.hpp"

#include <sstream>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "lattice/lattice.hpp"
#include "output/export/lammps_types.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

LammpsScene scene_for(const Plate& plate, const Numerics& numerics) {
  std::vector<std::string> notes;
  return lammps_scene(plate, numerics, 1e-7, notes);
}

// By the types, every near pair is bonded exactly if the lattice says so.
void expect_cuts(const Plate& plate, const Numerics& numerics) {
  const Lattice lattice(plate, numerics);
  const LammpsTypes types = lammps_types(scene_for(plate, numerics));
  const Grid& grid = lattice.grid;
  int wrong = 0, cut = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      lattice.family.for_each_bond([&](int a, int b, const Vec2&, double, int bit) {
        if (!grid.contains(i + a, j + b) || lattice.is_void(i, j) || lattice.is_void(i + a, j + b))
          return;
        const int one = types.of_node[grid.index(i, j)];
        const int other = types.of_node[grid.index(i + a, j + b)];
        const bool apart = types.apart.contains({std::min(one, other), std::max(one, other)});
        const bool holds = lattice.bonds.holds(grid.layout().at(i, j), bit);
        wrong += apart == holds ? 1 : 0;
        cut += holds ? 0 : 1;
      });
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(cut, 50);
}

TEST(LammpsTypes, CutWhatTheLatticeCuts) {
  Plate plate = test::edge_crack(12e6);
  const Numerics numerics = test::numerics(1e-3, 4e-3);
  expect_cuts(plate, numerics);
  plate.cracks.push_back({{60e-3, 5e-3}, {80e-3, 33e-3}});
  plate.cracks.push_back({{65e-3, 30e-3}, {85e-3, 12e-3}, Born::absent});
  plate.cutouts.push_back({Capsule{{{20e-3, 30e-3}, {30e-3, 32e-3}}, 0.6e-3}, ""});
  expect_cuts(plate, numerics);
}

TEST(LammpsTypes, OfAStraightCrackAreFew) {
  Plate plate = test::edge_crack(12e6);
  plate.no_fail.clear();
  const auto count = [&] {
    return lammps_types(scene_for(plate, test::numerics(1e-3, 4e-3))).strong.size();
  };
  const std::size_t types = count();
  EXPECT_GT(types, 3U);
  EXPECT_LT(types, 100U);
  // A longer crack has as many: they are those of its tip.
  plate.cracks[0].points[1].x() = 70e-3;
  EXPECT_LE(count(), types + 10);
}

TEST(LammpsDeck, HoldsAllNodesThatAreNotCutOut) {
  Plate plate = test::edge_crack(12e6);
  plate.cutouts.push_back({Ellipse{{0.08, 0.03}, {5e-3, 5e-3}}, ""});
  const Numerics numerics = test::numerics(2e-3, 6e-3);
  const Lattice lattice(plate, numerics);
  std::size_t nodes = 0;
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 50; ++i) nodes += lattice.is_void(i, j) ? 0 : 1;
  const std::string data = lammps_data(scene_for(plate, numerics));
  EXPECT_THAT(data, HasSubstr(fmt::format("\n{} atoms\n", nodes)));
  std::istringstream lines(data.substr(data.find("# peri\n\n") + 8));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) ++count;
  EXPECT_EQ(count, nodes);
}

TEST(LammpsDeck, SaysTheConstantsInItsUnits) {
  Plate plate = test::edge_crack(12e6);
  const Numerics numerics = test::numerics(2e-3, 6e-3);
  const Lattice lattice(plate, numerics);
  const double dt = 1e-7, dx = 2e-3;
  const std::string deck = lammps_deck(scene_for(plate, numerics), {.steps = 7}, "a.data");
  EXPECT_THAT(deck, HasSubstr("read_data a.data\n"));
  EXPECT_THAT(deck, HasSubstr("run 7\n"));
  EXPECT_THAT(deck, HasSubstr(fmt::format("pair_coeff * * {:.17g} ",
                                          lattice.calibration.c * dx * dt * dt / lattice.rho)));
  // The bottom row are the first 50 atoms.
  EXPECT_THAT(deck, HasSubstr("id 1:50:1\n"));
  EXPECT_THAT(deck, HasSubstr("id 951:1000:1\n"));
  EXPECT_THAT(deck, HasSubstr(fmt::format("addforce 0 {:.17g} 0\n",
                                          dt * dt / dx * (12e6 / (2235.0 * dx)))));
}

std::string objections_to(const Plate& plate, const Numerics& numerics) {
  try {
    scene_for(plate, numerics);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
}

TEST(LammpsScene, NamesAllThatLammpsCannotHave) {
  Plate plate = test::edge_crack(12e6);
  Numerics numerics = test::numerics(2e-3, 6e-3);
  EXPECT_EQ(objections_to(plate, numerics), "");
  plate.inclusions.push_back({Ellipse{{0.08, 0.03}, {5e-3, 5e-3}}, test::duran50()});
  plate.scatter = Scatter{Scatter::Kind::weibull, 12.0, 1e-3, 7};
  plate.contact = Contact{};
  plate.initial_conditions.push_back({{}, {}, Vec2(1.0, 0.0)});
  plate.loads.supports.emplace_back();
  plate.loads.thermal_loads.emplace_back();
  plate.loads.impactors.push_back({{-6e-3, 5e-3}, 4e-3, {80.0, 0.0}, 0.5});
  plate.loads.foundations.emplace_back();
  plate.loads.absorbers.emplace_back();
  plate.loads.damping = 1.0;
  plate.loads.tractions[0].amplitude = ramp(1e-6);
  plate.loads.tractions[1].stress = VectorField([](const Vec2&) { return Vec2(0, 0); });
  numerics.quadrature = Quadrature::area;
  numerics.micromodulus = Micromodulus::conical;
  numerics.surface = Surface::energy;
  const std::string said = objections_to(plate, numerics);
  for (const char* what : {"several materials", "scattered", "contact", "initial motion",
                           "supports", "temperature", "impactors", "foundations", "absorbing",
                           "damping", "amplitude", "functions", "\"area\"", "conical", "surfaces"})
    EXPECT_THAT(said, HasSubstr(what));
}

TEST(LammpsScene, NotesWhatLammpsDoesInAnotherWay) {
  std::vector<std::string> notes;
  Numerics numerics = test::numerics(2e-3, 6e-3);
  numerics.breaking = Breaking::next_step;
  Plate plate = test::edge_crack(12e6);
  plate.no_fail.clear();
  lammps_scene(plate, numerics, 1e-7, notes);
  EXPECT_TRUE(notes.empty());
  numerics.breaking = Breaking::at_once;
  numerics.precision = Precision::f32;
  numerics.quadrature = Quadrature::ramp;
  lammps_scene(test::edge_crack(12e6), numerics, 1e-7, notes);
  EXPECT_EQ(notes.size(), 4U);
}

}  // namespace
}  // namespace hackle
