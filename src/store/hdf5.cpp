// SPDX-License-Identifier: MIT
#include "store/hdf5.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace hackle {
namespace {

constexpr hsize_t most_chunk_values = 1 << 17;  // 512 KiB of f32: good for compression and reading
constexpr unsigned deflate_level = 4;

// The innermost message of HDF5's error stack, which names the cause.
std::string cause() {
  std::string text;
  const auto keep_innermost = [](unsigned n, const H5E_error2_t* error, void* into) -> herr_t {
    if (n == 0 && error->desc != nullptr) *static_cast<std::string*>(into) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &text);
  return text.empty() ? "unknown reason" : text;
}

Hdf5Handle text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), std::max<std::size_t>(size, 1));
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

// Whole rows, or parts of one when a row is long.
std::vector<hsize_t> chunk_of(const std::vector<hsize_t>& row_shape) {
  std::vector<hsize_t> chunk{1};
  hsize_t values = 1;
  for (const hsize_t extent : row_shape) values *= extent;
  chunk.insert(chunk.end(), row_shape.begin(), row_shape.end());
  if (!row_shape.empty() && values > most_chunk_values)
    chunk[1] = std::max<hsize_t>(1, most_chunk_values / (values / row_shape[0]));
  if (row_shape.empty()) chunk[0] = 1024;
  return chunk;
}

}  // namespace

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
  if (this != &other) {
    reset();
    id_ = std::exchange(other.id_, -1);
    close_ = other.close_;
  }
  return *this;
}

bool Hdf5Handle::reset() {
  if (id_ < 0) return true;
  return close_(std::exchange(id_, -1)) >= 0;
}

Hdf5File::Hdf5File(const std::filesystem::path& path) : path_(path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are thrown, not printed
  file_ = {checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), "create"),
           H5Fclose};
}

hid_t Hdf5File::checked(hid_t result, const std::string& doing) const {
  if (result >= 0) return result;
  throw Error(ErrorKind::files, "cannot " + doing + " '" + path_.string() + "': " + cause());
}

void Hdf5File::describe(hid_t object, const std::string& name, const std::string& text) {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(
      checked(H5Acreate2(object, name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT),
              "write " + name + " of"),
      H5Aclose);
  checked(H5Awrite(attribute.get(), type.get(), text.c_str()), "write " + name + " of");
}

void Hdf5File::attribute(const std::string& name, const std::string& text) {
  describe(file_.get(), name, text);
}

void Hdf5File::attribute(const std::string& name, long long number) {
  Hdf5Handle attribute;
  if (H5Aexists(file_.get(), name.c_str()) > 0) {
    attribute = {H5Aopen(file_.get(), name.c_str(), H5P_DEFAULT), H5Aclose};
  } else {
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    attribute = {
        H5Acreate2(file_.get(), name.c_str(), H5T_STD_I64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose};
  }
  checked(attribute.get(), "write " + name + " of");
  checked(H5Awrite(attribute.get(), H5T_NATIVE_LLONG, &number), "write " + name + " of");
}

Hdf5Handle Hdf5File::dataset(const std::string& name, hid_t type, std::vector<hsize_t> row_shape,
                             const std::string& units, const std::string& long_name) {
  std::vector<hsize_t> shape{0}, most{H5S_UNLIMITED};
  shape.insert(shape.end(), row_shape.begin(), row_shape.end());
  most.insert(most.end(), row_shape.begin(), row_shape.end());
  const std::vector<hsize_t> chunk = chunk_of(row_shape);
  const auto rank = static_cast<int>(shape.size());
  const Hdf5Handle space(H5Screate_simple(rank, shape.data(), most.data()), H5Sclose);
  const Hdf5Handle plan(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(plan.get(), rank, chunk.data());
  H5Pset_shuffle(plan.get());
  H5Pset_deflate(plan.get(), deflate_level);
  Hdf5Handle dataset(checked(H5Dcreate2(file_.get(), name.c_str(), type, space.get(), H5P_DEFAULT,
                                        plan.get(), H5P_DEFAULT),
                             "create " + name + " in"),
                     H5Dclose);
  describe(dataset.get(), "units", units);
  describe(dataset.get(), "long_name", long_name);
  return dataset;
}

void Hdf5File::append(const Hdf5Handle& dataset, hsize_t row, hid_t type, const void* values) {
  Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
  std::vector<hsize_t> shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.get())));
  H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr);
  shape[0] = row + 1;
  checked(H5Dset_extent(dataset.get(), shape.data()), "extend");
  space = {H5Dget_space(dataset.get()), H5Sclose};
  std::vector<hsize_t> start(shape.size(), 0), count = shape;
  start[0] = row;
  count[0] = 1;
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  const Hdf5Handle memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                          H5Sclose);
  checked(H5Dwrite(dataset.get(), type, memory.get(), space.get(), H5P_DEFAULT, values), "write");
}

void Hdf5File::write(const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
                     const void* values, const std::string& units, const std::string& long_name) {
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                         H5Sclose);
  const Hdf5Handle dataset(checked(H5Dcreate2(file_.get(), name.c_str(), type, space.get(),
                                              H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                   "create " + name + " in"),
                           H5Dclose);
  checked(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write");
  describe(dataset.get(), "units", units);
  describe(dataset.get(), "long_name", long_name);
}

void Hdf5File::write_text(const std::string& name, const std::string& text,
                          const std::string& long_name) {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle dataset(checked(H5Dcreate2(file_.get(), name.c_str(), type.get(), space.get(),
                                              H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                   "create " + name + " in"),
                           H5Dclose);
  checked(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()),
          "write");
  describe(dataset.get(), "long_name", long_name);
}

void Hdf5File::flush() {
  checked(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "write");
}

void Hdf5File::close() {
  if (!file_.reset()) throw Error(ErrorKind::files, "cannot close '" + path_.string() + "'");
}

}  // namespace hackle
