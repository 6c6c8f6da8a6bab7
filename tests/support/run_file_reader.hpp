// SPDX-License-Identifier: MIT
// Reads run files with the plain HDF5 library. Unreadable data have no extent and no values.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <hdf5.h>

namespace hackle::test {

class RunFileReader {
 public:
  explicit RunFileReader(const std::filesystem::path& path)
      : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    if (file_ >= 0) return;
    // A file that this process could not close is still open, without a lock.
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_file_locking(access, 0, 1);
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
    H5Pclose(access);
  }
  ~RunFileReader() {
    if (file_ >= 0) H5Fclose(file_);
  }
  RunFileReader(const RunFileReader&) = delete;
  RunFileReader& operator=(const RunFileReader&) = delete;

  bool opens() const { return file_ >= 0; }
  bool holds(const std::string& name) const {
    return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
  }

  std::vector<hsize_t> shape(const std::string& name) const {
    const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    if (dataset < 0) return {};
    const hid_t space = H5Dget_space(dataset);
    std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    H5Sclose(space);
    H5Dclose(dataset);
    return extents;
  }

  std::vector<double> numbers(const std::string& name) const {
    const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    if (dataset < 0) return {};
    std::size_t count = 1;
    for (const hsize_t extent : shape(name)) count *= extent;
    std::vector<double> values(count);
    const herr_t read =
        H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(dataset);
    return read < 0 ? std::vector<double>() : values;
  }

  std::string text(const std::string& name) const {
    const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    const hid_t type = H5Dget_type(dataset);
    std::string value(H5Tget_size(type), '\0');
    H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data());
    H5Tclose(type);
    H5Dclose(dataset);
    return value;
  }

  std::string attribute(const std::string& object, const std::string& name) const {
    const hid_t attribute =
        H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    std::string value(H5Tget_size(type), '\0');
    H5Aread(attribute, type, value.data());
    H5Tclose(type);
    H5Aclose(attribute);
    return value;
  }

  long long committed() const {
    const hid_t attribute = H5Aopen(file_, "records_committed", H5P_DEFAULT);
    long long value = -1;
    H5Aread(attribute, H5T_NATIVE_LLONG, &value);
    H5Aclose(attribute);
    return value;
  }

 private:
  hid_t file_;
};

}  // namespace hackle::test
