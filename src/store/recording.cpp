// SPDX-License-Identifier: MIT
#include "store/recording.hpp"

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/machine.hpp"
#include "lattice/check_numerics.hpp"
#include "solver/default_step.hpp"
#include "store/hdf5_reader.hpp"
#include "store/lattice_hash.hpp"
#include "store/recorded_bonds.hpp"
#include "store/recorded_run.hpp"
#include "store/run_file.hpp"
#include "store/xdmf.hpp"

namespace hackle {
namespace {

// Removes the loads: a shown plate never evaluates them.
Plate unloaded(Plate plate) {
  plate.loads = {};
  plate.initial_conditions.clear();
  plate.contact.reset();
  return plate;
}

// Accepts the recorded step unchecked, and uses f64, which suits every field.
Numerics recorded(Numerics numerics) {
  numerics.force_step = true;
  numerics.precision = Precision::f64;
  numerics.fused = false;
  numerics.fidelity = 0.0;
  return numerics;
}

// Pictures need every bond and the motion of every node.
void check_contents(const Hdf5Reader& file, const Grid& grid) {
  const RecordContents contents = contents_of(file, grid);
  if (contents.part)
    file.refuse("it holds only a part of the nodes of its plate",
                "ParaView opens its .xdmf; record without a region or coarsen for pictures");
  std::vector<std::string_view> lacking;
  for (const char* needed : {"displacement", "velocity", "bonds"})
    if (!contents.holds(needed)) lacking.emplace_back(needed);
  if (!lacking.empty())
    file.refuse(fmt::format("it was recorded without {}", fmt::join(lacking, ", ")),
                "ParaView opens its .xdmf; add them to the fields of s:record for pictures");
}

// An impossible scene is a fault of the file. Names are removed, so that no message quotes the
// file.
void check_scene(const Hdf5Reader& file, Plate plate, const Numerics& numerics) {
  plate.material.name.clear();
  for (Inclusion& inclusion : plate.inclusions) inclusion.material.name.clear();
  for (Cutout& cutout : plate.cutouts) cutout.name.clear();
  for (Outline& outline : plate.outlines) outline.name.clear();
  Problems problems;
  check(plate, problems);
  check(plate, numerics, available_memory(), problems);
  if (!problems.empty()) file.refuse(problems.list().front().what);
  // Checked before a lattice takes memory: it has as many nodes as the file has positions.
  const Grid grid = make_grid(plate, numerics.spacing);
  check_contents(file, grid);
  file.check_shape("nodes", {grid.nodes(), 3});
}

Lattice rebuilt(const Hdf5Reader& file, const Plate& plate, const Numerics& numerics) {
  check_scene(file, plate, numerics);
  try {
    return {plate, numerics};
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::files || error.kind() == ErrorKind::interrupted) throw;
    file.refuse("its lattice cannot be built");
  }
}

void check_lattice(const Hdf5Reader& file, const Lattice& lattice) {
  if (file.attribute("lattice_hash") != lattice_hash(lattice))
    file.refuse("its lattice cannot be built again",
                "run its script again with this version, or take the version that recorded it");
}

void put(const std::vector<double>& values, const Grid& grid, double unit, const char* what,
         const Hdf5Reader& file, const auto& set) {
  for (const double value : values)
    if (!std::isfinite(value)) file.refuse(fmt::format("a {} is not finite", what));
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const std::size_t at = 2 * grid.index(i, j);
      set(i, j, Vec2(values[at] / unit, values[at + 1] / unit));
    }
}

}  // namespace

struct Recording::Parts {
  explicit Parts(const std::filesystem::path& path_)
      : path(path_),
        run(path_),
        file(run.file()),
        plate(unloaded(run.inputs().plate)),
        numerics(recorded(run.inputs().numerics)),
        lattice(rebuilt(file, plate, numerics)),
        dt(numerics.step.value_or(default_step(plate, lattice, numerics.safety))),
        state(lattice, Precision::f64) {
    check_lattice(file, lattice);
    origin = {file.attribute("script_name"), file.text("script")};
  }

  // Shows the record in that group; nothing has changed if it throws.
  void show(const std::string& group, std::int64_t step, double time) {
    const Grid& grid = lattice.grid;
    State next(lattice, Precision::f64);
    std::vector<double> strain;
    Loads bodies;
    next.step = next.start = step;
    next.clock = {time, step};
    const std::vector<hsize_t> vectors{grid.nodes(), 3};
    put(file.doubles(group + "/displacement", vectors, 2), grid, grid.dx, "displacement", file,
        [&](int i, int j, const Vec2& u) { next.set_u(i, j, u); });
    put(file.doubles(group + "/velocity", vectors, 2), grid, grid.dx / dt, "velocity", file,
        [&](int i, int j, const Vec2& v) { next.set_v(i, j, v); });
    break_recorded(file, group, lattice, next.bonds);
    if (file.holds(group + "/thermal_strain"))
      strain = file.doubles(group + "/thermal_strain", {grid.nodes()}, 1);
    read_bodies(group, next, bodies);
    state = std::move(next);
    thermal_strain = std::move(strain);
    plate.loads = std::move(bodies);
  }

  // Puts the rigid bodies of a record into its state, and what they are into `shown_bodies`.
  void read_bodies(const std::string& group, State& next, Loads& shown_bodies) const {
    const Loads& loads = run.inputs().plate.loads;
    read_places(group + "/discs", loads.impactors.size(), 5, next.discs,
                [&](const Disc& disc, const double* size) {
                  shown_bodies.impactors.push_back({disc.centre, size[0], disc.velocity});
                });
    read_places(group + "/rollers", loads.rollers.size(), 5, next.rollers,
                [&](const Disc& disc, const double* size) {
                  shown_bodies.rollers.push_back({disc.centre, size[0], {}});
                });
    read_places(group + "/platens", loads.platens.size(), 6, next.platens,
                [&](const Disc& disc, const double* size) {
                  const Vec2 half(size[0], size[1]);
                  shown_bodies.platens.push_back({disc.centre - half, disc.centre + half, {}});
                });
  }

  // Calls add(place, size) for each body, the place in m and m/s.
  template <class Add>
  void read_places(const std::string& name, hsize_t count, hsize_t columns,
                   std::vector<Disc>& places, const Add& add) const {
    if (!file.holds(name)) return;
    const std::vector<double> values = file.doubles(name, {count, columns}, columns);
    for (std::size_t at = 0; at < values.size(); at += columns) {
      const double* value = values.data() + at;
      const Disc disc{{value[0], value[1]}, {value[2], value[3]}};
      places.push_back(
          {lattice.grid.from_centre(disc.centre), dt / lattice.grid.dx * disc.velocity});
      add(disc, value + 4);
    }
  }

  std::filesystem::path path;
  RecordedRun run;
  const Hdf5Reader& file;
  Plate plate;  // as it is shown: without loads but for the rigid bodies of the record
  Numerics numerics;
  Lattice lattice;
  double dt;  // s
  State state;
  std::vector<double> thermal_strain;
  Origin origin;
  std::size_t shown = 0;
};

Recording::Recording(const std::filesystem::path& path) : parts_(std::make_unique<Parts>(path)) {
  go_to(0);
}

Recording::~Recording() = default;

const std::filesystem::path& Recording::path() const {
  return parts_->path;
}

const Origin& Recording::origin() const {
  return parts_->origin;
}

const Plate& Recording::plate() const {
  return parts_->run.inputs().plate;
}

const std::vector<double>& Recording::times() const {
  return parts_->run.times();
}

std::size_t Recording::nearest(double time) const {
  return parts_->run.nearest(time);
}

void Recording::go_to(std::size_t record) {
  parts_->show(record_group(record), parts_->run.steps().at(record),
               parts_->run.times().at(record));
  parts_->shown = record;
}

std::size_t Recording::shown() const {
  return parts_->shown;
}

View Recording::view() const {
  return {parts_->plate, parts_->numerics, parts_->lattice,
          parts_->dt,    parts_->state,    parts_->thermal_strain};
}

std::size_t Recording::bytes() const {
  return parts_->state.bytes() + parts_->lattice.bytes();
}

}  // namespace hackle
