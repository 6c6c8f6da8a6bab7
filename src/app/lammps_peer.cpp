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
#include "output/export/lammps_deck.hpp"
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

LammpsScene bench_scene(const BenchDeck& deck, double alpha) {
  Plate plate = deck.plate;
  plate.material.alpha = alpha;
  plate.cracks.clear();
  plate.no_fail.clear();
  const Lattice lattice(plate, deck.numerics);
  std::vector<std::string> notes;
  return lammps_scene(plate, deck.numerics, default_step(lattice.step_limit), notes);
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
  const LammpsScene scene = bench_scene(deck, alpha);
  write_text(folder.path() / "plate.data", lammps_data(scene));
  write_text(folder.path() / "plate.in",
             lammps_deck(scene, {.steps = steps, .is_timed = true}, "plate.data"));
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
