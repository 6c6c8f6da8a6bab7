// SPDX-License-Identifier: MIT
#include "app/command_export.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/partial_file.hpp"
#include "base/terminal.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "output/export/csv_file.hpp"
#include "output/export/lammps_deck.hpp"
#include "output/export/vtk_file.hpp"
#include "output/export/vtkhdf_file.hpp"
#include "solver/default_step.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<fs::path>;

constexpr std::array<std::string_view, 4> export_endings{".csv", ".vtk", ".vtkhdf", ".in"};

fs::path output_of(const ExportRequest& request) {
  if (!request.output.empty()) return request.output;
  return fs::path(request.run.filename())
      .replace_extension(export_endings[static_cast<std::size_t>(request.kinds.front())]);
}

void check_output(const fs::path& path, const ExportRequest& request) {
  if (real_path(path) == real_path(request.run))
    throw Error(ErrorKind::usage, fmt::format("export: '{}' is the run itself", path.string()),
                "name another file with -o");
  refuse_if_written(path);
  check_writable(path);
  make_folder_of(path);
}

std::string heading_of(const StoredRun& run, const Lattice& lattice, double dt,
                       const fs::path& deck) {
  return fmt::format(
      "# The scene of {}, made by Hackle {}, for LAMMPS with its package PERI:\n"
      "#   lmp -in {}\n"
      "# Units: lengths {} m, times {} s, densities {} kg/m3\n",
      printable(run.path().filename().string()), version(), deck.filename().string(),
      shortest(lattice.grid.dx), shortest(dt), shortest(lattice.rho));
}

// The scene, from its start to the last state.
Files write_lammps(const StoredRun& run, const ExportRequest& request, const fs::path& deck) {
  const Inputs& inputs = run.inputs();
  const Lattice& lattice = run.view().lattice();
  const double dt = run.view().dt();
  std::vector<std::string> notes;
  const LammpsScene scene = lammps_scene(inputs.plate, inputs.numerics, dt, notes);
  LammpsPlan plan{run.last_step(), run.last_step()};
  if (request.wishes.every)
    plan.every = std::max<std::int64_t>(1, std::llround(*request.wishes.every / dt));
  plan.heading = heading_of(run, lattice, dt, deck);
  const fs::path data = fs::path(deck).replace_extension(".data");
  check_output(data, request);
  write_text(data, lammps_data(scene));
  write_text(deck, lammps_deck(scene, plan, data.filename().string()));
  for (const std::string& note : notes)
    if (!request.quiet) say_note(note);
  return {deck, data};
}

Files write_states(StoredRun& run, const ExportRequest& request, const fs::path& path) {
  ExportWishes wishes = request.wishes;
  wishes.all_times = request.kinds.front() == ExportKind::vtkhdf;
  const ExportChoice choice = chosen(run, wishes);
  Progress progress(talk(request.quiet));
  const ShareDone done = [&](double share) {
    if (progress.due(share)) progress.show(share, "writing");
  };
  if (request.kinds.front() == ExportKind::vtk) return write_vtk(run, choice, path, done);
  if (request.kinds.front() == ExportKind::csv)
    write_csv(run, choice, path, done);
  else
    write_vtkhdf(run, choice, path, done);
  return {path};
}

}  // namespace

int command_export(const ExportRequest& request) {
  const InterruptHandler handler;
  return exit_code_of([&] {
    if (request.kinds.size() != 1)
      throw Error(ErrorKind::usage, "export: it is not clear what to write",
                  "name one of --csv, --vtk, --vtkhdf and --lammps");
    StoredRun run(request.run);
    const fs::path path = output_of(request);
    check_output(path, request);
    const Files files = request.kinds.front() == ExportKind::lammps
                            ? write_lammps(run, request, path)
                            : write_states(run, request, path);
    if (request.quiet) return 0;
    for (const fs::path& file : files) tell_file(file);
    return 0;
  });
}

}  // namespace hackle
