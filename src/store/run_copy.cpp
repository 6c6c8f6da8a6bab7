// SPDX-License-Identifier: MIT
#include "store/run_copy.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"
#include "store/hdf5_reader.hpp"
#include "store/xdmf.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr const char* remedy = "begin anew with --fresh";

void check_source(const fs::path& path, int format, std::size_t nodes, std::int64_t records) {
  const Hdf5Reader file(path);
  if (!file.has_attribute("software") || file.attribute("software") != "Hackle" ||
      file.integer("format_version") != format)
    file.refuse("it is no run file of this version", remedy);
  file.check_shape("nodes", {nodes, 3});
  if (const std::int64_t committed = file.integer("records_committed"); committed < records)
    file.refuse(fmt::format("it has {} records, the run to go on with had {}", committed, records),
                remedy);
}

// Copies objects and attributes from one file to another.
class Copier {
 public:
  Copier(const fs::path& from, Hdf5File& to)
      : from_path_(from),
        access_(without_locks()),
        from_(checked(H5Fopen(from.c_str(), H5F_ACC_RDONLY, access_.get()), "open"), H5Fclose),
        to_(to) {}

  // Texts and numbers of the root; of others, none are ours.
  void copy_attributes() const {
    H5O_info_t info{};
    checked(H5Oget_info2(from_.get(), &info, H5O_INFO_NUM_ATTRS), "read");
    for (hsize_t k = 0; k < info.num_attrs; ++k) copy_attribute(k);
  }

  void copy(const std::string& name) const {
    checked(H5Ocopy(from_.get(), name.c_str(), to_.root().get(), name.c_str(), H5P_DEFAULT,
                    H5P_DEFAULT),
            "copy " + name + " of");
  }

  std::vector<std::string> names() const {
    H5G_info_t info{};
    checked(H5Gget_info(from_.get(), &info), "read");
    std::vector<std::string> list;
    for (hsize_t k = 0; k < info.nlinks; ++k) list.push_back(name_of(k));
    return list;
  }

 private:
  template <class Result>
  Result checked(Result result, const std::string& doing) const {
    if (result >= 0) return result;
    throw Error(ErrorKind::files,
                fmt::format("cannot {} '{}': {}", doing, from_path_.string(), cause_of_failure()),
                remedy);
  }

  std::string name_of(hsize_t index) const {
    const auto get = [&](char* text, std::size_t size) {
      return checked(H5Lget_name_by_idx(from_.get(), ".", H5_INDEX_NAME, H5_ITER_INC, index, text,
                                        size, H5P_DEFAULT),
                     "read");
    };
    std::string name(static_cast<std::size_t>(get(nullptr, 0)), '\0');
    get(name.data(), name.size() + 1);
    return name;
  }

  void copy_attribute(hsize_t index) const {
    const Hdf5Handle attribute(checked(H5Aopen_by_idx(from_.get(), ".", H5_INDEX_NAME, H5_ITER_INC,
                                                      index, H5P_DEFAULT, H5P_DEFAULT),
                                       "read"),
                               H5Aclose);
    const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
    const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
    const H5T_class_t kind = H5Tget_class(type.get());
    const bool fixed = H5Tis_variable_str(type.get()) == 0;
    if (!((kind == H5T_STRING && fixed) || kind == H5T_INTEGER) ||
        H5Sget_simple_extent_npoints(space.get()) != 1)
      return;
    std::string value(H5Tget_size(type.get()), '\0');
    checked(H5Aread(attribute.get(), type.get(), value.data()), "read");
    std::string name(
        static_cast<std::size_t>(checked(H5Aget_name(attribute.get(), 0, nullptr), "read")), '\0');
    H5Aget_name(attribute.get(), name.size() + 1, name.data());
    const Hdf5Handle copy(checked(H5Acreate2(to_.root().get(), name.c_str(), type.get(),
                                             space.get(), H5P_DEFAULT, H5P_DEFAULT),
                                  "copy"),
                          H5Aclose);
    checked(H5Awrite(copy.get(), type.get(), value.data()), "copy");
  }

  fs::path from_path_;
  Hdf5Handle access_, from_;
  Hdf5File& to_;
};

// A series of the copy loses the values of later records.
void shorten(const Hdf5File& file, const std::string& name, hsize_t records) {
  const Hdf5Handle dataset(H5Dopen2(file.root().get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
  hsize_t count = 0, most = 0;
  if (H5Sget_simple_extent_ndims(space.get()) != 1 ||
      H5Sget_simple_extent_dims(space.get(), &count, &most) != 1 || most != H5S_UNLIMITED)
    return;
  if (count < records || H5Dset_extent(dataset.get(), &records) < 0)
    throw Error(ErrorKind::files, fmt::format("the series {} is shorter than the records", name),
                remedy);
}

void copy_records(const Copier& copier, Hdf5File& to, std::int64_t records) {
  to.name(to.group(max_record_groups), "records");
  for (std::size_t k = 0; k < static_cast<std::size_t>(records); ++k) {
    if (k % records_a_group == 0)
      to.name(to.group(records_a_group), fmt::format("records/{}", k / records_a_group));
    copier.copy(record_group(k));
  }
}

}  // namespace

Hdf5File first_records(const fs::path& path, int format, std::size_t nodes, std::int64_t records) {
  check_source(path, format, nodes, records);
  const PartialFile partial(path);
  Hdf5File to(partial_name(path));
  const Copier copier(path, to);
  copier.copy_attributes();
  to.attribute("records_committed", records);
  to.attribute("complete", 0LL);
  for (const std::string& name : copier.names()) {
    if (name == "records" || name == "series") continue;  // tables come with the end of the file
    copier.copy(name);
    shorten(to, name, static_cast<hsize_t>(records));
  }
  copy_records(copier, to, records);
  to.flush();
  to.rename(path);
  return to;
}

}  // namespace hackle
