// SPDX-License-Identifier: MIT
#include "peer/lammps.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "base/text.hpp"
#include "output/export/lammps_deck.hpp"

namespace hackle::test {
namespace {

LammpsScene scene_of(const PeerPlate& plate) {
  LammpsScene scene;
  scene.grid = plate.grid;
  scene.removed = plate.removed;
  scene.m = plate.m;
  scene.is_ramped = true;
  scene.c = plate.c;
  scene.s00 = plate.s00;
  scene.alpha = plate.alpha;
  scene.pull.assign(plate.grid.nodes(), Vec2(0.0, 0.0));
  for (int i = 0; i < plate.grid.nx; ++i) {
    scene.pull[plate.grid.index(i, plate.grid.ny - 1)] = {0.0, plate.pull};
    scene.pull[plate.grid.index(i, 0)] = {0.0, -plate.pull};
  }
  return scene;
}

// Reads one snapshot of a dump; returns false at its end.
bool read_sample(std::istream& file, const Grid& grid, PeerSample& sample) {
  std::string line;
  std::size_t count = 0;
  if (!std::getline(file, line)) return false;  // ITEM: TIMESTEP
  file >> sample.step >> std::ws;
  std::getline(file, line);  // ITEM: NUMBER OF ATOMS
  file >> count >> std::ws;
  for (int k = 0; k < 5; ++k) std::getline(file, line);  // the box, ITEM: ATOMS
  sample.u.assign(grid.nodes(), Vec2{0, 0});
  sample.damage.assign(grid.nodes(), 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t atom = 0;
    Vec2 place;
    double damage = 0.0;
    file >> atom >> place.x() >> place.y() >> damage >> std::ws;
    const auto i = static_cast<int>((atom - 1) % static_cast<std::size_t>(grid.nx));
    const auto j = static_cast<int>((atom - 1) / static_cast<std::size_t>(grid.nx));
    sample.u[atom - 1] = place - grid.from_centre(i, j);
    sample.damage[atom - 1] = damage;
  }
  return !file.fail();
}

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

bool lammps_is_installed() {
  return std::system("command -v lmp > /dev/null 2>&1") == 0;
}

std::vector<PeerSample> run_deck(const std::filesystem::path& folder, const Grid& grid) {
  const std::string command =
      fmt::format("cd {} && OMP_NUM_THREADS=1 lmp -in plate.in -log none -screen none > said 2>&1",
                  shell_word(folder.string()));
  if (std::system(command.c_str()) != 0)
    throw std::runtime_error("LAMMPS failed: " + text_of(folder / "said"));
  std::ifstream file(folder / "nodes.dump");
  std::vector<PeerSample> samples;
  for (PeerSample sample; read_sample(file, grid, sample);) samples.push_back(sample);
  return samples;
}

std::vector<PeerSample> run_lammps(const PeerPlate& plate, int steps, int every,
                                   const std::filesystem::path& folder) {
  const LammpsScene scene = scene_of(plate);
  std::ofstream(folder / "plate.data") << lammps_data(scene);
  std::ofstream(folder / "plate.in")
      << lammps_deck(scene, {.steps = steps, .every = every}, "plate.data");
  return run_deck(folder, plate.grid);
}

}  // namespace hackle::test
