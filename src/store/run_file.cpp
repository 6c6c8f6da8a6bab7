// SPDX-License-Identifier: MIT
#include "store/run_file.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/version.hpp"
#include "store/exact_state.hpp"
#include "store/hdf5.hpp"
#include "store/hdf5_reader.hpp"
#include "store/inputs.hpp"
#include "store/lattice_hash.hpp"
#include "store/record_arrays.hpp"
#include "store/run_copy.hpp"
#include "store/run_series.hpp"
#include "store/xdmf.hpp"

namespace hackle {
namespace {

// Per record, beside its fields: bonds, thermal strain, three kinds of bodies, the journal, five
// arrays and the rest of an exact state.
constexpr unsigned more_members = 12;

std::vector<double> places(const Grid& grid, const NodeWindow& nodes) {
  std::vector<double> list;
  list.reserve(2 * nodes.nodes());
  nodes.for_each([&](int i, int j) {
    const Vec2 place = grid.position(i, j);
    list.insert(list.end(), {place.x(), place.y()});
  });
  return list;
}

std::vector<std::uint8_t> materials_of(const Lattice& lattice, const NodeWindow& nodes) {
  std::vector<std::uint8_t> list;
  list.reserve(nodes.nodes());
  nodes.for_each([&](int i, int j) { list.push_back(lattice.material[lattice.grid.index(i, j)]); });
  return list;
}

Hdf5Handle text_of_hash() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), hash_digits);
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);  // no room for a terminator
  return type;
}

// The types of the values of a dataset, in the file and in memory.
hid_t file_type_of(const RecordArray& array) {
  const std::array types{H5T_IEEE_F32LE, H5T_IEEE_F64LE, H5T_STD_U32LE};
  return types.at(array.values.index());
}
hid_t memory_type_of(const RecordArray& array) {
  const std::array types{H5T_NATIVE_FLOAT, H5T_NATIVE_DOUBLE, H5T_NATIVE_UINT32};
  return types.at(array.values.index());
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

double run_file_bytes(const RecordContents& contents, const Grid& grid, std::int64_t records) {
  constexpr double fixed = 1e5, places = 4.0, a_record = 8e3, a_scalar = 3.0, standard = 8.0;
  constexpr double exact = 40.0;  // bytes of each node
  const auto nodes = static_cast<double>(contents.nodes.nodes());
  const auto others = static_cast<double>(std::ranges::count_if(contents.fields, [](const auto& f) {
    return std::ranges::find(usual_records, f) == usual_records.end();
  }));
  const double of_record = a_record + nodes * (standard + a_scalar * others) +
                           (contents.exact ? exact * static_cast<double>(grid.nodes()) : 0.0);
  return fixed + places * nodes + static_cast<double>(records) * of_record;
}

struct RunFile::Parts {
  Parts(const std::filesystem::path& path_, const Simulation& simulation, const Origin& origin,
        RecordContents contents_)
      : path(path_),
        contents(std::move(contents_)),
        grid(simulation.lattice().grid),
        file(prepared(path_)) {
    describe(simulation, origin);
    const hsize_t nodes = contents.nodes.nodes();
    file.write(file.root(), {"nodes", H5T_IEEE_F64LE, {nodes, 3}, "m", "positions of the nodes"},
               H5T_NATIVE_DOUBLE, 2, places(grid, contents.nodes).data());
    has_material = !simulation.lattice().material.empty();
    if (has_material)
      file.write(file.root(),
                 {"material",
                  H5T_STD_U8LE,
                  {nodes},
                  "",
                  "0: of the plate, k: of its k-th other material, 255: cut out"},
                 H5T_NATIVE_UINT8, 1, materials_of(simulation.lattice(), contents.nodes).data());
    time = file.series("time", H5T_IEEE_F64LE, "s", "simulated time of each record");
    step = file.series("step", H5T_STD_I64LE, "", "time steps done at each record");
    hash_type = text_of_hash();
    hash = file.series("state_hash", hash_type.get(), "", "hash of the state after that step");
    file.name(file.group(max_record_groups), "records");
    file.flush();
  }
  // Goes on behind the first records of the file.
  Parts(const std::filesystem::path& path_, const Grid& grid_, const RecordContents& contents_,
        std::int64_t records)
      : path(path_),
        contents(contents_),
        grid(grid_),
        file(first_records(path_, run_file_format, contents_.nodes.nodes(), records)),
        time(file.series("time")),
        step(file.series("step")),
        hash_type(text_of_hash()),
        hash(file.series("state_hash")),
        shown(sidecar_fields(contents_)) {
    const Hdf5Reader written(path_);
    times = written.first_doubles("time", static_cast<hsize_t>(records));
    has_material = written.holds("material");
    write_sidecar();
  }

  // Writes the data of a record into its group.
  void write(const Hdf5Handle& group, const Simulation& simulation, const std::string& journal) {
    const bool with_state = contents.exact || times.empty();
    shown.clear();
    for_each_dataset(simulation, contents, with_state, [&](const RecordArray& array) {
      std::visit(
          [&](const auto& values) {
            file.write(group,
                       {array.name, file_type_of(array), array.shape, array.unit, array.long_name},
                       memory_type_of(array), array.given, values.data());
          },
          array.values);
      if (contents.holds(array.name)) shown.push_back(shown_in_sidecar(array));
    });
    if (with_state)
      file.write_text(group, "state", exact_head(simulation),
                      "the rest of the state to the last bit, in JSON");
    if (!journal.empty())
      file.write_text(group, "journal", journal, "what was done since the last record, in JSON");
  }

  static SidecarField shown_in_sidecar(const RecordArray& array) {
    const bool is_double = std::holds_alternative<std::vector<double>>(array.values);
    return {array.name, array.shape.size() > 1 ? 3 : 1, is_double ? 8 : 4};
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
    file.write_text(file.root(), "script", origin.script_text, "the script that made this run");
    file.write_text(file.root(), "inputs", inputs_of(simulation),
                    "plate and numerics, resolved, in JSON");
    file.write_text(file.root(), "contents", text_of(contents), "what is recorded, in JSON");
  }

  // Starts a group for the next thousand records.
  void begin_thousand() {
    const Hdf5Handle group = file.group(records_a_group);
    file.flush();
    file.name(group, "records/" + std::to_string(times.size() / records_a_group));
  }

  void write_sidecar() {
    hackle::write_text(sidecar_of(path),
                       xdmf(grid_of(contents.nodes, grid), path, times, has_material, shown));
    in_sidecar = times.size();
  }

  std::filesystem::path path;
  RecordContents contents;
  Grid grid;
  Hdf5File file;
  Hdf5Handle time, step, hash_type, hash;
  std::vector<double> times;
  std::vector<SidecarField> shown;  // in the sidecar
  bool has_material = false;
  std::size_t in_sidecar = 0;
};

RunFile::RunFile(const std::filesystem::path& path, const Simulation& simulation,
                 const Origin& origin, std::optional<RecordContents> contents)
    : parts_(std::make_unique<Parts>(
          path, simulation, origin,
          contents ? std::move(*contents) : standard_contents(simulation.lattice().grid))) {
}

RunFile::RunFile(const std::filesystem::path& path, const Grid& grid,
                 const RecordContents& contents, std::int64_t records)
    : parts_(std::make_unique<Parts>(path, grid, contents, records)) {
}

RunFile::~RunFile() = default;

void RunFile::add(const Simulation& simulation, const std::string& journal) {
  const std::size_t record = parts_->times.size();
  Hdf5File& file = parts_->file;
  if (record % records_a_group == 0) parts_->begin_thousand();
  // Three flushes: first data without links, then their names, then the count that commits them. At
  // no moment does committed data depend on bytes that are still to be written.
  const auto fields = static_cast<unsigned>(parts_->contents.fields.size());
  const Hdf5Handle group = file.group(fields + more_members);
  parts_->write(group, simulation, journal);
  file.flush();

  const double time = simulation.time();
  const std::int64_t step = simulation.state().step;
  const std::string hash = simulation.state().hash();
  file.name(group, record_group(record));
  file.append(parts_->time, record, H5T_NATIVE_DOUBLE, &time);
  file.append(parts_->step, record, H5T_NATIVE_INT64, &step);
  file.append(parts_->hash, record, parts_->hash_type.get(), hash.data());
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
  parts_->hash.reset();
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
