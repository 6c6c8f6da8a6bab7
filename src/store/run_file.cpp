// SPDX-License-Identifier: MIT
#include "store/run_file.hpp"

#include <array>
#include <cmath>
#include <ctime>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/version.hpp"
#include "measure/field.hpp"
#include "store/hdf5.hpp"
#include "store/inputs.hpp"
#include "store/lattice_hash.hpp"
#include "store/run_series.hpp"
#include "store/xdmf.hpp"

namespace hackle {
namespace {

constexpr unsigned max_groups = 1000;  // of a thousand records each
constexpr unsigned max_members = 6;    // per record

std::vector<double> places(const Grid& grid) {
  std::vector<double> list;
  list.reserve(2 * grid.nodes());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const Vec2 place = grid.position(i, j);
      list.insert(list.end(), {place.x(), place.y()});
    }
  return list;
}

void require_finite(const Field& field) {
  for (const float value : field.values)
    if (!std::isfinite(value))
      throw Error(ErrorKind::run_failed,
                  fmt::format("record: the {} is not a finite number everywhere", field.name),
                  "take a smaller step");
}

// Returns the bonds broken since the start as bits, node by node, the words of each together.
std::vector<std::uint32_t> broken_bonds(const Simulation& simulation) {
  const Grid& grid = simulation.lattice().grid;
  const BondBits &initial = simulation.lattice().bonds, &now = simulation.state().bonds;
  const auto words = static_cast<std::size_t>(simulation.lattice().family.words());
  std::vector<std::uint32_t> broken;
  broken.reserve(words * grid.nodes());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      auto at = static_cast<std::size_t>(grid.layout().at(i, j));
      for (std::size_t word = 0; word < words; ++word, at += initial.plane())
        broken.push_back(initial.words()[at] & ~now.words()[at]);
    }
  return broken;
}

// Returns position (m) and velocity (m/s) of each rigid body, and the size (m) that size_of(body)
// gives: one number or two.
template <class Body, class SizeOf>
std::vector<double> bodies_at(const std::vector<Disc>& places, const std::vector<Body>& bodies,
                              const Simulation& simulation, const SizeOf& size_of) {
  const Grid& grid = simulation.lattice().grid;
  std::vector<double> list;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vec2 place = grid.centre + grid.dx * places[k].centre;
    const Vec2 velocity = grid.dx / simulation.dt() * places[k].velocity;
    list.insert(list.end(), {place.x(), place.y(), velocity.x(), velocity.y()});
    for (const double size : size_of(bodies[k])) list.push_back(size);
  }
  return list;
}

// The sidecar is rewritten whenever the number of records has grown by this factor: its cost stays
// linear in the number of records, and a killed run leaves a sidecar that opens.
constexpr double sidecar_growth = 1.1;

// Refuses a name that the sidecar would take, and removes an older run file, which a recording may
// still have open, with its sidecar.
const std::filesystem::path& prepared(const std::filesystem::path& path) {
  if (sidecar_of(path) == path)
    throw Error(ErrorKind::files, fmt::format("cannot write a run file to '{}'", path.string()),
                "end its name in .h5; the .xdmf beside it is written for you");
  std::error_code ignored;
  std::filesystem::remove(sidecar_of(path), ignored);
  const std::filesystem::path real = real_path(path);
  if (std::filesystem::is_regular_file(real, ignored)) std::filesystem::remove(real, ignored);
  return path;
}

}  // namespace

std::filesystem::path sidecar_of(std::filesystem::path run_file) {
  return run_file.replace_extension(".xdmf");
}

double run_file_bytes(std::size_t nodes, std::int64_t records) {
  constexpr double fixed = 1e5, places = 4.0, a_record = 8e3, a_node_and_record = 8.0;
  const auto each = static_cast<double>(nodes), times = static_cast<double>(records);
  return fixed + places * each + times * (a_record + a_node_and_record * each);
}

struct RunFile::Parts {
  Parts(const std::filesystem::path& path_, const Simulation& simulation, const Origin& origin)
      : path(path_), grid(simulation.lattice().grid), file(prepared(path_)) {
    describe(simulation, origin);
    write(file.root(), {"nodes", H5T_IEEE_F64LE, {grid.nodes(), 3}, "m", "positions of the nodes"},
          H5T_NATIVE_DOUBLE, 2, places(grid).data());
    has_material = !simulation.lattice().material.empty();
    if (has_material)
      write(file.root(),
            {"material",
             H5T_STD_U8LE,
             {grid.nodes()},
             "",
             "0: of the plate, k: of its k-th other material, 255: cut out"},
            H5T_NATIVE_UINT8, 1, simulation.lattice().material.data());
    time = file.series("time", H5T_IEEE_F64LE, "s", "simulated time of each record");
    step = file.series("step", H5T_STD_I64LE, "", "time steps done at each record");
    file.name(file.group(max_groups), "records");
    file.flush();
  }

  void write(const Hdf5Handle& group, const Dataset& dataset, hid_t memory_type, hsize_t columns,
             const void* values) {
    file.write(group, dataset, memory_type, columns, values);
  }

  // Writes a field that ParaView shows; vectors need three components.
  void write_field(const Hdf5Handle& group, const Field& field, const std::string& long_name) {
    require_finite(field);
    std::vector<hsize_t> shape{grid.nodes()};
    if (field.components > 1) shape.push_back(3);
    write(group, {field.name, H5T_IEEE_F32LE, shape, field.unit, long_name}, H5T_NATIVE_FLOAT,
          static_cast<hsize_t>(field.components), field.values.data());
  }

  // Writes the rest of the state.
  void write_state(const Hdf5Handle& group, const Simulation& simulation) {
    const auto words = static_cast<hsize_t>(simulation.lattice().family.words());
    write(group,
          {"broken",
           H5T_STD_U32LE,
           {grid.nodes(), words},
           "",
           "bits of the kept bonds of a node that have broken since the start"},
          H5T_NATIVE_UINT32, words, broken_bonds(simulation).data());
    if (const std::vector<double>& strain = simulation.thermal_strain(); !strain.empty())
      write(group, {"thermal_strain", H5T_IEEE_F32LE, {grid.nodes()}, "", "thermal strain"},
            H5T_NATIVE_DOUBLE, 1, strain.data());
    write_bodies(group, simulation);
  }

  void write_bodies(const Hdf5Handle& group, const Simulation& simulation) {
    const View view = simulation.view();
    const State& state = view.state();
    const Loads& loads = simulation.plate().loads;
    const auto radius = [](const auto& body) { return std::array{body.radius}; };
    const auto half = [](const Platen& platen) {
      const Vec2 size = 0.5 * (platen.to - platen.from).cwiseAbs();
      return std::array{size.x(), size.y()};
    };
    write_bodies(group, "discs", "impactor", "radius",
                 bodies_at(state.discs, loads.impactors, simulation, radius), 5);
    write_bodies(group, "rollers", "roller", "radius",
                 bodies_at(state.rollers, loads.rollers, simulation, radius), 5);
    write_bodies(group, "platens", "platen", "half of width and height",
                 bodies_at(state.platens, loads.platens, simulation, half), 6);
  }

  void write_bodies(const Hdf5Handle& group, const char* name, const char* body, const char* size,
                    const std::vector<double>& list, hsize_t columns) {
    if (list.empty()) return;
    const std::string meaning =
        fmt::format("of each {}: position x and y (m), velocity x and y (m/s), {} (m)", body, size);
    write(group, {name, H5T_IEEE_F64LE, {list.size() / columns, columns}, "", meaning},
          H5T_NATIVE_DOUBLE, columns, list.data());
  }

  void describe(const Simulation& simulation, const Origin& origin) {
    file.attribute("format_version", run_file_format);
    file.attribute("records_committed", 0LL);
    file.attribute("complete", 0LL);
    file.attribute("software", std::string("Hackle"));
    file.attribute("version", std::string(version()));
    file.attribute("git_hash", std::string(git_hash()));
    file.attribute("compiler", std::string(compiler()));
    file.attribute("created",
                   fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
    file.attribute("script_name", origin.script_name);
    file.attribute("lattice_hash", lattice_hash(simulation.lattice()));
    file.write_text("script", origin.script_text, "the script that made this run");
    file.write_text("inputs", inputs_of(simulation), "plate and numerics, resolved, in JSON");
  }

  // Starts a group for the next thousand records.
  void begin_thousand() {
    const Hdf5Handle group = file.group(records_a_group);
    file.flush();
    file.name(group, "records/" + std::to_string(times.size() / records_a_group));
  }

  void write_sidecar() {
    hackle::write_text(sidecar_of(path), xdmf(grid, path, times, has_material));
    in_sidecar = times.size();
  }

  std::filesystem::path path;
  Grid grid;
  Hdf5File file;
  Hdf5Handle time, step;
  std::vector<double> times;
  bool has_material = false;
  std::size_t in_sidecar = 0;
};

RunFile::RunFile(const std::filesystem::path& path, const Simulation& simulation,
                 const Origin& origin)
    : parts_(std::make_unique<Parts>(path, simulation, origin)) {
}

RunFile::~RunFile() = default;

void RunFile::add(const Simulation& simulation) {
  const std::size_t record = parts_->times.size();
  Hdf5File& file = parts_->file;
  if (record % records_a_group == 0) parts_->begin_thousand();
  // Three flushes: first data without links, then their names, then the count that commits them. At
  // no moment does committed data depend on bytes that are still to be written.
  const Hdf5Handle group = file.group(max_members);
  parts_->write_field(group, damage(simulation), "share of a node's initial bonds that are broken");
  parts_->write_field(group, displacement(simulation), "displacement of the nodes");
  parts_->write_field(group, velocity(simulation), "velocity of the nodes");
  parts_->write_state(group, simulation);
  file.flush();

  const double time = simulation.time();
  const std::int64_t step = simulation.state().step;
  file.name(group, record_group(record));
  file.append(parts_->time, record, H5T_NATIVE_DOUBLE, &time);
  file.append(parts_->step, record, H5T_NATIVE_INT64, &step);
  file.flush();
  file.attribute("records_committed", static_cast<long long>(record) + 1);
  file.flush();
  parts_->times.push_back(time);
  const auto records = static_cast<double>(parts_->times.size());
  if (records >= sidecar_growth * static_cast<double>(parts_->in_sidecar)) parts_->write_sidecar();
}

void RunFile::add(std::span<const SeriesTable> tables) {
  write_series(parts_->file, tables);
}

void RunFile::finish() {
  if (!parts_->times.empty()) parts_->write_sidecar();
  parts_->file.attribute("complete", 1LL);
  parts_->time.reset();
  parts_->step.reset();
  parts_->file.close();
}

std::filesystem::path RunFile::path() const {
  return parts_->path;
}

std::filesystem::path RunFile::sidecar() const {
  return sidecar_of(parts_->path);
}

std::string RunFile::library_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("HDF5 {}.{}.{}", major, minor, release);
}

}  // namespace hackle
