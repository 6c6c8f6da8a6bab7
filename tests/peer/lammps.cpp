// SPDX-License-Identifier: MIT
#include "peer/lammps.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "base/text.hpp"

namespace hackle::test {
namespace {

// Atom n + 1 is node n. The box is shrink-wrapped, so no atom is the periodic image of another.
void write_atoms(const PeerPlate& plate, const std::filesystem::path& path) {
  const Grid& grid = plate.grid;
  std::ofstream file(path);
  fmt::print(file, "nodes of a plate\n\n{} atoms\n1 atom types\n",
             std::ranges::count(plate.removed, 0));
  fmt::print(file, "{} {} xlo xhi\n{} {} ylo yhi\n-0.5 0.5 zlo zhi\n\nAtoms # peri\n\n",
             -0.5 * grid.nx, 0.5 * grid.nx, -0.5 * grid.ny, 0.5 * grid.ny);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (plate.removed[grid.index(i, j)]) continue;
      const Vec2 place = grid.from_centre(i, j);
      const int volume = 1, density = 1;
      fmt::print(file, "{} 1 {} {} {} {} 0\n", grid.index(i, j) + 1, volume, density, place.x(),
                 place.y());
    }
}

// `lattice` tells LAMMPS the spacing, which determines the width of the ramp and the reach of its
// contact forces. addforce acts on the force density, which is divided by the density.
void write_deck(const PeerPlate& plate, int steps, int every, const std::filesystem::path& path) {
  const double top = 0.5 * (plate.grid.ny - 1);
  std::ofstream file(path);
  fmt::print(file, R"(units lj
dimension 2
boundary s s p
atom_style peri
atom_modify map array sort 0 0
lattice sq 1.0
read_data atoms.data
pair_style peri/pmb
pair_coeff 1 1 {c:.17g} {m:.17g} {s00:.17g} {alpha:.17g}
neighbor 0.5 bin
region top block INF INF {top} INF INF INF
region bottom block INF INF INF -{top} INF INF
group top region top
group bottom region bottom
fix up top addforce 0 {pull:.17g} 0
fix down bottom addforce 0 {push:.17g} 0
fix move all nve
compute damage all damage/atom
dump nodes all custom {every} nodes.dump id x y c_damage
dump_modify nodes sort id format float %.17g
thermo {steps}
timestep 1
run {steps}
)",
             fmt::arg("c", plate.c), fmt::arg("m", plate.m), fmt::arg("s00", plate.s00),
             fmt::arg("alpha", plate.alpha), fmt::arg("top", top), fmt::arg("pull", plate.pull),
             fmt::arg("push", -plate.pull), fmt::arg("every", every), fmt::arg("steps", steps));
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

std::vector<PeerSample> run_lammps(const PeerPlate& plate, int steps, int every,
                                   const std::filesystem::path& folder) {
  write_atoms(plate, folder / "atoms.data");
  write_deck(plate, steps, every, folder / "plate.in");
  const std::string command =
      fmt::format("cd {} && OMP_NUM_THREADS=1 lmp -in plate.in -log none -screen none > said 2>&1",
                  shell_word(folder.string()));
  if (std::system(command.c_str()) != 0)
    throw std::runtime_error("LAMMPS failed: " + text_of(folder / "said"));
  std::ifstream file(folder / "nodes.dump");
  std::vector<PeerSample> samples;
  for (PeerSample sample; read_sample(file, plate.grid, sample);) samples.push_back(sample);
  return samples;
}

}  // namespace hackle::test
