// SPDX-License-Identifier: MIT
#include "store/hdf5.hpp"

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "base/error.hpp"

namespace hackle {
namespace {

constexpr hsize_t max_chunk_values = 1 << 17;  // 512 KiB of f32: good for compression and reading
constexpr hsize_t series_chunk = 2048;
constexpr unsigned deflate_level = 1;  // level 4 takes 1.4 times as long for 2 % less

// Returns the system's message, e.g. "No space left on device", out of the many details of the
// driver.
std::string system_message(const std::string& text) {
  constexpr std::string_view before = "error message = '";
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) return text;
  const std::string rest = text.substr(begin + before.size());
  return rest.substr(0, rest.find('\''));
}

Hdf5Handle text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), std::max<std::size_t>(size, 1));
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);  // no room for a terminator
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

// Does not store the time at which a dataset is written: the same run gives the same bytes.
Hdf5Handle timeless() {
  Hdf5Handle plan(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(plan.get(), 0);
  return plan;
}

// Defines chunks and compression of a dataset: each column separately, in chunks of at most 512 KiB
// of f32.
Hdf5Handle storage(std::vector<hsize_t> shape) {
  shape[0] = std::clamp<hsize_t>(shape[0], 1, max_chunk_values);
  if (shape.size() > 1) shape[1] = 1;
  Hdf5Handle plan = timeless();
  H5Pset_chunk(plan.get(), static_cast<int>(shape.size()), shape.data());
  H5Pset_shuffle(plan.get());
  H5Pset_deflate(plan.get(), deflate_level);
  H5Pset_fletcher32(plan.get());  // a disk fault must be an error, not a wrong picture
  return plan;
}

}  // namespace

// Returns the innermost message of HDF5's error stack, which names the cause.
std::string cause_of_failure() {
  std::string text;
  const auto keep_innermost = [](unsigned n, const H5E_error2_t* error, void* into) -> herr_t {
    if (n == 0 && error->desc != nullptr) *static_cast<std::string*>(into) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &text);
  return text.empty() ? "unknown reason" : system_message(text);
}

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

void begin_hdf5() {
  [[maybe_unused]] static const herr_t once = H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Handle without_locks() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access.get(), 0, 1);
  return access;
}

Hdf5File::Hdf5File(const std::filesystem::path& path) : path_(path) {
  begin_hdf5();
  // Committed data never depend on bytes that are still to be written, so that readers find a whole
  // file at any moment.
  const Hdf5Handle access = without_locks();
  file_ = {checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), "create"),
           H5Fclose};
}

hid_t Hdf5File::checked(hid_t result, const std::string& doing) const {
  if (result >= 0) return result;
  throw Error(ErrorKind::files,
              "cannot " + doing + " '" + path_.string() + "': " + cause_of_failure());
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

Hdf5Handle Hdf5File::group(unsigned members) {
  constexpr unsigned name_length = 16;
  const Hdf5Handle plan(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  // Groups of the old format spread their names over three structures, which a flush writes one
  // after another. Tracking the order makes a group of the new format, and the two limits keep all
  // its names in its header, which is written at once.
  H5Pset_link_creation_order(plan.get(), H5P_CRT_ORDER_TRACKED);
  H5Pset_link_phase_change(plan.get(), 0xFFFF, 0xFFFF);
  H5Pset_est_link_info(plan.get(), members, name_length);
  return {checked(H5Gcreate_anon(file_.get(), plan.get(), H5P_DEFAULT), "write"), H5Gclose};
}

void Hdf5File::name(const Hdf5Handle& group, const std::string& name) {
  checked(H5Olink(group.get(), file_.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "write");
}

Hdf5Handle Hdf5File::series(const std::string& name, hid_t type, const std::string& units,
                            const std::string& long_name) {
  const hsize_t none = 0, unlimited = H5S_UNLIMITED;
  const Hdf5Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose);
  // Not compressed: a chunk that grows under compression moves in the file, and a process killed
  // meanwhile would leave an index that points to its old place.
  const Hdf5Handle plan = timeless();
  H5Pset_chunk(plan.get(), 1, &series_chunk);
  Hdf5Handle series(checked(H5Dcreate2(file_.get(), name.c_str(), type, space.get(), H5P_DEFAULT,
                                       plan.get(), H5P_DEFAULT),
                            "create " + name + " in"),
                    H5Dclose);
  describe(series.get(), "units", units);
  describe(series.get(), "long_name", long_name);
  return series;
}

Hdf5Handle Hdf5File::series(const std::string& name) {
  return {checked(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), "open " + name + " in"),
          H5Dclose};
}

void Hdf5File::append(const Hdf5Handle& series, hsize_t index, hid_t type, const void* value) {
  const hsize_t count = index + 1, one = 1;
  checked(H5Dset_extent(series.get(), &count), "extend");
  const Hdf5Handle space(H5Dget_space(series.get()), H5Sclose);
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, &index, nullptr, &one, nullptr);
  const Hdf5Handle memory(H5Screate_simple(1, &one, nullptr), H5Sclose);
  checked(H5Dwrite(series.get(), type, memory.get(), space.get(), H5P_DEFAULT, value), "write");
}

void Hdf5File::write(const Hdf5Handle& group, const Dataset& dataset, hid_t memory_type,
                     hsize_t columns, const void* values) {
  std::vector<hsize_t> given = dataset.shape;
  const int extents = static_cast<int>(given.size());
  const Hdf5Handle space(H5Screate_simple(extents, given.data(), nullptr), H5Sclose);
  const Hdf5Handle plan = storage(given);
  const Hdf5Handle made(checked(H5Dcreate2(group.get(), dataset.name.c_str(), dataset.file_type,
                                           space.get(), H5P_DEFAULT, plan.get(), H5P_DEFAULT),
                                "create " + dataset.name + " in"),
                        H5Dclose);
  if (extents > 1) given[1] = columns;
  const std::vector<hsize_t> begin(given.size(), 0);
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, begin.data(), nullptr, given.data(), nullptr);
  const Hdf5Handle memory(H5Screate_simple(extents, given.data(), nullptr), H5Sclose);
  checked(H5Dwrite(made.get(), memory_type, memory.get(), space.get(), H5P_DEFAULT, values),
          "write");
  describe(made.get(), "units", dataset.units);
  describe(made.get(), "long_name", dataset.long_name);
}

void Hdf5File::write_text(const Hdf5Handle& group, const std::string& name, const std::string& text,
                          const std::string& long_name) {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle dataset(checked(H5Dcreate2(group.get(), name.c_str(), type.get(), space.get(),
                                              H5P_DEFAULT, timeless().get(), H5P_DEFAULT),
                                   "create " + name + " in"),
                           H5Dclose);
  checked(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()),
          "write");
  describe(dataset.get(), "long_name", long_name);
}

void Hdf5File::rename(const std::filesystem::path& path) {
  flush();
  void* descriptor = nullptr;
  checked(H5Fget_vfd_handle(file_.get(), H5P_DEFAULT, &descriptor), "write");
  std::error_code failure;
  if (::fsync(*static_cast<int*>(descriptor)) == 0)
    std::filesystem::rename(path_, path, failure);
  else
    failure = {errno, std::generic_category()};
  if (failure)
    throw Error(ErrorKind::files, "cannot create '" + path.string() + "': " + failure.message());
  path_ = path;
}

void Hdf5File::flush() {
  checked(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "write");
}

void Hdf5File::close() {
  checked(file_.reset() ? 0 : -1, "close");
}

}  // namespace hackle
