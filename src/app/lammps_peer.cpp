// SPDX-License-Identifier: MIT
#include "app/lammps_peer.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "solver/default_step.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

// A temporary folder, removed with this object.
class ScratchFolder {
 public:
  ScratchFolder() : path_(fs::temp_directory_path() / fmt::format("hackle_bench_{}", getpid())) {
    fs::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return "it said nothing";
  const std::size_t start = text.find_last_of('\n', end);
  return text.substr(start + 1, end - start);
}

std::smatch find(const std::string& log, const char* pattern) {
  std::smatch match;
  if (!std::regex_search(log, match, std::regex(pattern)))
    throw Error(ErrorKind::run_failed, fmt::format("the log of LAMMPS has no '{}'", pattern));
  return match;
}

}  // namespace

bool lammps_is_installed() {
  return std::system("command -v lmp > /dev/null 2>&1") == 0;
}

std::string lammps_deck(const BenchDeck& deck, double alpha, int steps) {
  const Lattice lattice(deck.plate, deck.numerics);
  const double dx = lattice.grid.dx, rho = lattice.rho;
  const double load =
      deck.plate.loads.tractions.front().stress.constant().y() / dx;  // force density, N/m3
  return fmt::format(
      R"(units si
dimension 2
boundary s s p
atom_style peri
atom_modify map array
lattice sq {dx:.17g}
region plate block 0 {right} 0 {top} -0.5 0.5
create_box 1 plate
create_atoms 1 region plate
set group all density {rho:.17g}
set group all volume {volume:.17g}
pair_style peri/pmb
pair_coeff 1 1 {c:.17g} {horizon:.17g} {s0:.17g} {alpha:.17g}
neighbor {skin:.17g} bin
neigh_modify every 1000000 delay 1000000 check no
region top_row block INF INF {below_top} INF INF INF
region bottom_row block INF INF INF 0.5 INF INF
group top region top_row
group bottom region bottom_row
fix up top addforce 0 {load:.17g} 0
fix down bottom addforce 0 -{load:.17g} 0
fix move all nve
thermo {steps}
timestep {dt:.17g}
run {steps}
)",
      fmt::arg("dx", dx), fmt::arg("right", lattice.grid.nx - 0.5),
      fmt::arg("top", lattice.grid.ny - 0.5), fmt::arg("below_top", lattice.grid.ny - 1.5),
      fmt::arg("rho", rho), fmt::arg("volume", dx * dx), fmt::arg("c", lattice.calibration.c),
      // Rounded positions must not decide whether a neighbour exactly at the horizon counts.
      fmt::arg("horizon", (1.0 + 1e-6) * lattice.family.m() * dx),
      fmt::arg("s0", lattice.calibration.s0), fmt::arg("alpha", alpha), fmt::arg("skin", 0.1 * dx),
      fmt::arg("load", load), fmt::arg("steps", steps),
      fmt::arg("dt", default_step(lattice.step_limit)));
}

LammpsRun read_lammps_log(const std::string& log) {
  LammpsRun run;
  const std::smatch loop =
      find(log, R"(Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms)");
  run.seconds = std::stod(loop[1]);
  run.steps = std::stoi(loop[2]);
  run.nodes = std::stoi(loop[3]);
  run.version = find(log, R"(LAMMPS \(([^)]*)\))")[1];
  run.megabytes = std::stod(find(log, R"(memory allocation .* = (\S+) \|)")[1]);
  return run;
}

LammpsRun run_lammps(const BenchDeck& deck, double alpha, int steps) {
  const ScratchFolder folder;
  write_text(folder.path() / "plate.in", lammps_deck(deck, alpha, steps));
  const std::string command =
      fmt::format("cd {} && OMP_NUM_THREADS=1 lmp -in plate.in -log log -screen none > said 2>&1",
                  shell_word(folder.path().string()));
  const int status = std::system(command.c_str());
  // The shell hides Ctrl-C from us while it waits.
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT)
    throw Error(ErrorKind::interrupted, "interrupted, nothing was measured");
  if (status != 0)
    throw Error(ErrorKind::run_failed,
                "LAMMPS failed: " + last_line(read_text(folder.path() / "said")));
  return read_lammps_log(read_text(folder.path() / "log"));
}

}  // namespace hackle
