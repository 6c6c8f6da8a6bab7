// SPDX-License-Identifier: MIT
#include "output/export/vtkhdf_file.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"
#include "store/hdf5.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using Extents = std::vector<hsize_t>;

constexpr hsize_t max_chunk_rows = 1 << 15;
constexpr unsigned deflate = 1;
constexpr std::uint8_t vertex_cell = 1;  // VTK_VERTEX

// The file while it is written. Every function throws Error (files).
class VtkHdf {
 public:
  VtkHdf(const fs::path& path, bool is_temporal) : path_(path) {
    begin_hdf5();
    const Hdf5Handle access = without_locks();  // PartialFile has locked it
    file_ = {
        checked(H5Fcreate(partial_name(path).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get())),
        H5Fclose};
    root_ = group(file_, "VTKHDF");
    const std::array<std::int64_t, 2> version{is_temporal ? 2 : 1, 0};
    attribute(root_, "Version", H5T_STD_I64LE, H5T_NATIVE_INT64, 2, version.data());
    constexpr std::string_view type = "UnstructuredGrid";
    const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);  // ASCII
    H5Tset_size(text.get(), type.size());
    H5Tset_strpad(text.get(), H5T_STR_NULLPAD);
    attribute(root_, "Type", text.get(), text.get(), 0, type.data());
  }

  const Hdf5Handle& root() const { return root_; }

  Hdf5Handle group(const Hdf5Handle& in, const char* name) const {
    return {checked(H5Gcreate2(in.get(), name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)), H5Gclose};
  }

  // `count` 0: a scalar.
  void attribute(const Hdf5Handle& in, const char* name, hid_t type, hid_t memory_type,
                 hsize_t count, const void* values) const {
    const Hdf5Handle space(
        count == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), H5Sclose);
    const Hdf5Handle made(
        checked(H5Acreate2(in.get(), name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT)), H5Aclose);
    checked(H5Awrite(made.get(), memory_type, values));
  }

  // Creates a dataset in compressed chunks.
  Hdf5Handle dataset(const Hdf5Handle& in, const char* name, hid_t type,
                     const Extents& shape) const {
    const auto ranks = static_cast<int>(shape.size());
    const Hdf5Handle space(H5Screate_simple(ranks, shape.data(), nullptr), H5Sclose);
    const Hdf5Handle plan(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    Extents chunk = shape;
    chunk[0] = std::clamp<hsize_t>(chunk[0], 1, max_chunk_rows);
    H5Pset_obj_track_times(plan.get(), 0);  // the same run gives the same bytes
    H5Pset_chunk(plan.get(), ranks, chunk.data());
    H5Pset_shuffle(plan.get());
    H5Pset_deflate(plan.get(), deflate);
    return {checked(H5Dcreate2(in.get(), name, type, space.get(), H5P_DEFAULT, plan.get(),
                               H5P_DEFAULT)),
            H5Dclose};
  }

  // Writes the rows from `row` on.
  void write(const Hdf5Handle& dataset, hsize_t row, const Extents& rows, hid_t memory_type,
             const void* values) const {
    Extents begin(rows.size(), 0);
    begin[0] = row;
    const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
    const Hdf5Handle memory(H5Screate_simple(static_cast<int>(rows.size()), rows.data(), nullptr),
                            H5Sclose);
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, begin.data(), nullptr, rows.data(), nullptr);
    checked(H5Dwrite(dataset.get(), memory_type, memory.get(), space.get(), H5P_DEFAULT, values));
  }

  void write_integers(const Hdf5Handle& in, const char* name,
                      const std::vector<std::int64_t>& values, hsize_t columns = 0) const {
    const Extents shape =
        columns == 0 ? Extents{values.size()} : Extents{values.size() / columns, columns};
    write(dataset(in, name, H5T_STD_I64LE, shape), 0, shape, H5T_NATIVE_INT64, values.data());
  }

  void finish() {
    checked(root_.reset() ? 0 : -1);
    checked(file_.reset() ? 0 : -1);
    publish(path_);
  }

 private:
  hid_t checked(hid_t result) const {
    if (result >= 0) return result;
    throw Error(ErrorKind::files,
                fmt::format("cannot write '{}': {}", path_.string(), cause_of_failure()));
  }

  fs::path path_;
  Hdf5Handle file_, root_;
};

void write_geometry(const VtkHdf& file, const std::vector<ExportNode>& nodes, const Grid& grid) {
  const auto count = static_cast<std::int64_t>(nodes.size());
  std::vector<double> places;
  for (const auto& [i, j] : nodes)
    for (const double value : {grid.position(i, j).x(), grid.position(i, j).y(), 0.0})
      places.push_back(value);
  std::vector<std::int64_t> numbers(nodes.size() + 1);
  std::iota(numbers.begin(), numbers.end(), 0);
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    file.write_integers(file.root(), name, {count});
  const Extents shape{nodes.size(), 3};
  file.write(file.dataset(file.root(), "Points", H5T_IEEE_F64LE, shape), 0, shape,
             H5T_NATIVE_DOUBLE, places.data());
  file.write_integers(file.root(), "Offsets", numbers);
  numbers.pop_back();
  file.write_integers(file.root(), "Connectivity", numbers);
  const std::vector<std::uint8_t> types(nodes.size(), vertex_cell);
  file.write(file.dataset(file.root(), "Types", H5T_STD_U8LE, {nodes.size()}), 0, {nodes.size()},
             H5T_NATIVE_UINT8, types.data());
}

// All times share the one part, its points and its cells; only the fields go on.
void write_steps(const VtkHdf& file, const std::vector<double>& times,
                 const std::vector<std::string>& fields, std::size_t nodes) {
  const Hdf5Handle steps = file.group(file.root(), "Steps");
  const auto count = static_cast<std::int64_t>(times.size());
  file.attribute(steps, "NSteps", H5T_STD_I64LE, H5T_NATIVE_INT64, 0, &count);
  file.write(file.dataset(steps, "Values", H5T_IEEE_F64LE, {times.size()}), 0, {times.size()},
             H5T_NATIVE_DOUBLE, times.data());
  const std::vector<std::int64_t> zeros(times.size(), 0), ones(times.size(), 1);
  for (const char* name : {"PartOffsets", "PointOffsets"}) file.write_integers(steps, name, zeros);
  file.write_integers(steps, "NumberOfParts", ones);
  for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"})
    file.write_integers(steps, name, zeros, 1);
  std::vector<std::int64_t> offsets;
  for (std::int64_t k = 0; k < count; ++k) offsets.push_back(k * static_cast<std::int64_t>(nodes));
  const Hdf5Handle of_fields = file.group(steps, "PointDataOffsets");
  for (const std::string& name : fields) file.write_integers(of_fields, name.c_str(), offsets);
}

// Returns the values of the nodes; those of a vector with a third component.
std::vector<float> packed(const Field& field, const std::vector<ExportNode>& nodes,
                          const Grid& grid) {
  std::vector<float> values;
  for (const auto& [i, j] : nodes) {
    const std::size_t node = grid.index(i, j);
    if (field.components == 1)
      values.push_back(field.values[node]);
    else
      values.insert(values.end(), {field.values[2 * node], field.values[2 * node + 1], 0.0F});
  }
  return values;
}

}  // namespace

void write_vtkhdf(StoredRun& run, const ExportChoice& choice, const fs::path& path,
                  const ShareDone& done) {
  const PartialFile held(path);
  const std::size_t count = choice.states.size();
  VtkHdf file(path, count > 1);
  const Grid grid = run.view().lattice().grid;
  const std::vector<ExportNode> nodes = export_nodes(run.view().lattice());
  write_geometry(file, nodes, grid);
  std::vector<double> times;
  for (const std::size_t state : choice.states) times.push_back(run.times()[state]);
  if (count > 1) write_steps(file, times, choice.fields, nodes.size());
  std::map<std::string, Hdf5Handle> datasets;
  {
    const Hdf5Handle data = file.group(file.root(), "PointData");
    hsize_t row = 0;
    for_each_state(run, choice, done, [&](double, const std::vector<Field>& fields) {
      for (const Field& field : fields) {
        const bool is_vector = field.components > 1;
        Hdf5Handle& dataset = datasets[field.name];
        if (row == 0)
          dataset = file.dataset(
              data, field.name.c_str(), H5T_IEEE_F32LE,
              is_vector ? Extents{count * nodes.size(), 3} : Extents{count * nodes.size()});
        file.write(dataset, row, is_vector ? Extents{nodes.size(), 3} : Extents{nodes.size()},
                   H5T_NATIVE_FLOAT, packed(field, nodes, grid).data());
      }
      row += nodes.size();
    });
    datasets.clear();
  }
  file.finish();
}

}  // namespace hackle
