// SPDX-License-Identifier: MIT
#include "store/hdf5_reader.hpp"

#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"

namespace hackle {
namespace {

constexpr std::size_t most_text = std::size_t{1} << 26U;  // bytes
constexpr hsize_t most_rows = 1'000'000;
constexpr std::string_view locked = "Resource temporarily unavailable";

std::string extents_text(const std::vector<hsize_t>& shape) {
  return fmt::format("{}", fmt::join(shape, " x "));
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : path_(path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are thrown, not printed
  std::error_code failure;
  if (!std::filesystem::exists(path, failure)) refuse("there is no such file");
  if (std::filesystem::is_directory(path, failure)) refuse("it is a folder");
  file_ = {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
  if (file_.get() >= 0) return;
  const std::string why = cause_of_failure();
  if (H5Fis_hdf5(path.c_str()) == 0) refuse(why, "a run file is what s:record{} writes");
  refuse(why, why == locked ? "another program is writing it: wait for its end" : "");
}

void Hdf5Reader::refuse(const std::string& what, const std::string& remedy) const {
  throw Error(ErrorKind::files, fmt::format("cannot read '{}': {}", path_.string(), what), remedy);
}

bool Hdf5Reader::has_attribute(const std::string& name) const {
  return H5Aexists(file_.get(), name.c_str()) > 0;
}

std::int64_t Hdf5Reader::integer(const std::string& name) const {
  const Hdf5Handle attribute(H5Aopen(file_.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
  std::int64_t value = 0;
  if (H5Sget_simple_extent_npoints(space.get()) != 1 ||
      H5Aread(attribute.get(), H5T_NATIVE_INT64, &value) < 0)
    refuse(fmt::format("its {} is missing or damaged", name));
  return value;
}

// A text of the length that its type says.
std::string Hdf5Reader::text_of(hid_t type, const std::string& name, const auto& read) const {
  const bool fixed = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
  const std::size_t size = fixed ? H5Tget_size(type) : 0;
  std::string value(size <= most_text ? size : 0, '\0');
  if (value.empty() || read(value.data()) < 0)
    refuse(fmt::format("its {} is missing or damaged", name));
  return value.substr(0, value.find('\0'));
}

std::string Hdf5Reader::attribute(const std::string& name) const {
  const Hdf5Handle attribute(H5Aopen(file_.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.get()) != 1)
    refuse(fmt::format("its {} is missing or damaged", name));
  return text_of(type.get(), name,
                 [&](char* text) { return H5Aread(attribute.get(), type.get(), text); });
}

std::string Hdf5Reader::text(const std::string& name) const {
  const Hdf5Handle dataset = open(name);
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose);
  if (!shape_of(dataset, name).empty()) refuse(fmt::format("its {} is no text", name));
  return text_of(type.get(), name, [&](char* text) {
    return H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
  });
}

bool Hdf5Reader::holds(const std::string& name) const {
  return H5Lexists(file_.get(), name.c_str(), H5P_DEFAULT) > 0;
}

Hdf5Handle Hdf5Reader::open(const std::string& name) const {
  Hdf5Handle dataset(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (dataset.get() < 0) refuse(fmt::format("its {} is missing or damaged", name));
  return dataset;
}

std::vector<hsize_t> Hdf5Reader::shape_of(const Hdf5Handle& dataset,
                                          const std::string& name) const {
  const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
  const int extents = H5Sget_simple_extent_ndims(space.get());
  if (extents < 0) refuse(fmt::format("the shape of its {} is damaged", name));
  std::vector<hsize_t> shape(static_cast<std::size_t>(extents));
  H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr);
  return shape;
}

hsize_t Hdf5Reader::rows(const std::string& name, hsize_t columns) const {
  const std::vector<hsize_t> shape = shape_of(open(name), name);
  if (shape.size() != 2 || shape[1] != columns || shape[0] > most_rows)
    refuse(fmt::format("its {} is {}, expected rows of {}", name, extents_text(shape), columns));
  return shape[0];
}

template <class Number>
std::vector<Number> Hdf5Reader::part(const std::string& name, const Hdf5Handle& dataset,
                                     const std::vector<hsize_t>& extents, hid_t type) const {
  const std::vector<hsize_t> begin(extents.size(), 0);
  const int count = static_cast<int>(extents.size());
  const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
  const Hdf5Handle memory(H5Screate_simple(count, extents.data(), nullptr), H5Sclose);
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, begin.data(), nullptr, extents.data(), nullptr);
  std::size_t size = 1;
  for (const hsize_t extent : extents) size *= extent;
  std::vector<Number> values(size);
  if (H5Dread(dataset.get(), type, memory.get(), space.get(), H5P_DEFAULT, values.data()) < 0)
    refuse(fmt::format("its {} is damaged: {}", name, cause_of_failure()));
  return values;
}

Hdf5Handle Hdf5Reader::open_series(const std::string& name, hsize_t count) const {
  Hdf5Handle dataset = open(name);
  const std::vector<hsize_t> shape = shape_of(dataset, name);
  if (shape.size() != 1 || shape[0] < count)
    refuse(fmt::format("its {} is {}, expected {}", name, extents_text(shape), count));
  return dataset;
}

Hdf5Handle Hdf5Reader::open_shaped(const std::string& name,
                                   const std::vector<hsize_t>& shape) const {
  Hdf5Handle dataset = open(name);
  const std::vector<hsize_t> found = shape_of(dataset, name);
  if (found != shape)
    refuse(
        fmt::format("its {} is {}, expected {}", name, extents_text(found), extents_text(shape)));
  return dataset;
}

std::vector<double> Hdf5Reader::first_doubles(const std::string& name, hsize_t count) const {
  const Hdf5Handle dataset = open_series(name, count);
  return part<double>(name, dataset, {count}, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> Hdf5Reader::first_integers(const std::string& name, hsize_t count) const {
  const Hdf5Handle dataset = open_series(name, count);
  return part<std::int64_t>(name, dataset, {count}, H5T_NATIVE_INT64);
}

std::vector<double> Hdf5Reader::doubles(const std::string& name, const std::vector<hsize_t>& shape,
                                        hsize_t columns) const {
  const Hdf5Handle dataset = open_shaped(name, shape);
  std::vector<hsize_t> extents = shape;
  if (extents.size() > 1) extents[1] = columns;
  return part<double>(name, dataset, extents, H5T_NATIVE_DOUBLE);
}

std::vector<std::uint32_t> Hdf5Reader::words(const std::string& name,
                                             const std::vector<hsize_t>& shape) const {
  const Hdf5Handle dataset = open_shaped(name, shape);
  return part<std::uint32_t>(name, dataset, shape, H5T_NATIVE_UINT32);
}

}  // namespace hackle
