// SPDX-License-Identifier: MIT
#include "store/hdf5_reader.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "store/unpacked_size.hpp"

namespace hackle {
namespace {

constexpr std::size_t max_text = std::size_t{1} << 26U;       // bytes
constexpr std::size_t max_attribute = std::size_t{1} << 16U;  // bytes, the limit of the format
constexpr hsize_t max_piece = hsize_t{1} << 21U;              // bytes; ours are at most half of it
constexpr hsize_t min_piece = 1024;                           // rows, if there are as many
constexpr std::size_t small_piece = std::size_t{1} << 16U;    // bytes; unpacks to at most 66 MB
constexpr hsize_t rows_at_once = hsize_t{1} << 20U;
constexpr hsize_t max_packed = 1100;  // deflate compresses by at most a factor of 1032
constexpr std::string_view locked = "Resource temporarily unavailable";
constexpr std::string_view cut_off = "it is cut off";
constexpr int max_trials = 20;  // to open a growing file
constexpr std::chrono::milliseconds between_trials{5};

std::string extents_text(const std::vector<hsize_t>& shape) {
  return fmt::format("{}", fmt::join(shape, " x "));
}

constexpr std::array<H5Z_filter_t, 3> our_filters{H5Z_FILTER_DEFLATE, H5Z_FILTER_SHUFFLE,
                                                  H5Z_FILTER_FLETCHER32};

H5Z_filter_t filter_at(const Hdf5Handle& plan, int place) {
  unsigned flags = 0;
  std::size_t values = 0;
  return H5Pget_filter2(plan.get(), static_cast<unsigned>(place), &flags, &values, nullptr, 0,
                        nullptr, nullptr);
}

bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  constexpr std::size_t max_size = 8;
  return (kind == H5T_INTEGER || kind == H5T_FLOAT) && H5Tget_size(type) <= max_size;
}

// Our own words: those of the library may repeat names from the file.
std::string plain_cause() {
  const std::string cause = cause_of_failure();
  for (const auto& [part, plain] : {std::pair{"signature", "it is no HDF5 file"},
                                    {"truncated", cut_off.data()},
                                    {"hecksum", "its checksum is wrong"},
                                    {"fletcher32", "its checksum is wrong"},
                                    {"locked", "it is locked"}})
    if (cause.find(part) != std::string::npos) return plain;
  return cause == locked || cause == std::strerror(EACCES) || cause == std::strerror(EMFILE) ||
                 cause == std::strerror(EIO)
             ? cause
             : "it is damaged";
}

// Sets `why` if the file cannot be opened.
Hdf5Handle opened_once(const std::filesystem::path& path, std::string& why) {
  // closed only after the cause is read, which closing would erase
  const Hdf5Handle access = without_locks();
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
  if (file.get() < 0) why = plain_cause();
  return file;
}

// The library reads the actual file length before the length that the file states. A file that grew
// in between looks cut off, but not repeatedly.
Hdf5Handle opened_growing(const std::filesystem::path& path, std::string& why) {
  for (int trial = 1;; ++trial) {
    Hdf5Handle file = opened_once(path, why);
    if (file.get() >= 0 || why != cut_off || trial == max_trials) return file;
    std::this_thread::sleep_for(between_trials);
  }
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : path_(path) {
  begin_hdf5();
  std::error_code failure;
  if (!std::filesystem::exists(path, failure)) refuse("there is no such file");
  if (std::filesystem::is_directory(path, failure)) refuse("it is a folder");
  if (!std::filesystem::is_regular_file(path, failure)) refuse("it is no plain file");
  std::string why;
  file_ = opened_growing(path, why);
  if (file_.get() >= 0) return;
  if (H5Fis_hdf5(path.c_str()) == 0) refuse(why, "s:record{} writes run files");
  refuse(why, why == locked ? "another program is writing it: wait for its end" : "");
}

void Hdf5Reader::refuse(const std::string& what, const std::string& remedy) const {
  throw Error(ErrorKind::files, fmt::format("cannot read '{}': {}", path_.string(), what), remedy);
}

bool Hdf5Reader::has_attribute(const std::string& name) const {
  return H5Aexists(file_.get(), name.c_str()) > 0;
}

Hdf5Handle Hdf5Reader::open_attribute(const std::string& name) const {
  Hdf5Handle attribute(H5Aopen(file_.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.get()) != 1)
    refuse(fmt::format("its {} is missing or damaged", name));
  return attribute;
}

std::int64_t Hdf5Reader::integer(const std::string& name) const {
  const Hdf5Handle attribute = open_attribute(name);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
  std::int64_t value = 0;
  if (!is_number(type.get()) || H5Aread(attribute.get(), H5T_NATIVE_INT64, &value) < 0)
    refuse(fmt::format("its {} is missing or damaged", name));
  return value;
}

// Reads a text of the length given by its type.
std::string Hdf5Reader::text_of(hid_t type, const std::string& name, std::size_t max,
                                const auto& read) const {
  const bool fixed = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
  const std::size_t size = fixed ? H5Tget_size(type) : 0;
  std::string value(size <= max ? size : 0, '\0');
  if (value.empty() || read(value.data()) < 0)
    refuse(fmt::format("its {} is missing or damaged", name));
  return value.substr(0, value.find('\0'));
}

std::string Hdf5Reader::attribute(const std::string& name) const {
  const Hdf5Handle attribute = open_attribute(name);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
  return text_of(type.get(), name, max_attribute,
                 [&](char* text) { return H5Aread(attribute.get(), type.get(), text); });
}

std::string Hdf5Reader::text(const std::string& name) const {
  const Hdf5Handle dataset = open(name);
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose);
  if (!shape_of(dataset, name).empty()) refuse(fmt::format("its {} is no text", name));
  // The text is stored uncompressed: if it is longer than its storage, we did not write it.
  if (H5Dget_storage_size(dataset.get()) < H5Tget_size(type.get()))
    refuse(fmt::format("its {} is missing or damaged", name));
  stop_if_interrupted();
  return text_of(type.get(), name, max_text, [&](char* text) {
    return H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
  });
}

// Checks the last part of a path whose other parts are plain links.
void Hdf5Reader::check_link(const std::string& name) const {
  H5L_info_t link{};
  if (H5Lget_info(file_.get(), name.c_str(), &link, H5P_DEFAULT) < 0)
    refuse(fmt::format("its {} is missing or damaged", name));
  if (link.type == H5L_TYPE_HARD) return;
  const bool leads_out = link.type == H5L_TYPE_EXTERNAL;
  refuse(fmt::format("its {} is {}", name, leads_out ? "a link to another file" : "only a link"),
         "a run file contains all of its data");
}

// Returns whether the name exists and is reached by plain links only.
bool Hdf5Reader::find(const std::string& name) const {
  for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {
    const std::string part = name.substr(0, end);
    if (H5Lexists(file_.get(), part.c_str(), H5P_DEFAULT) <= 0) return false;
    check_link(part);
    if (end == std::string::npos) return true;
  }
}

bool Hdf5Reader::holds(const std::string& name) const {
  return find(name);
}

std::vector<std::string> Hdf5Reader::names(const std::string& group) const {
  constexpr std::size_t max_name = 256;
  if (group != "/" && !find(group)) refuse(fmt::format("its {} is missing or damaged", group));
  H5G_info_t info{};
  if (H5Gget_info_by_name(file_.get(), group.c_str(), &info, H5P_DEFAULT) < 0) return {};
  std::vector<std::string> names;
  for (hsize_t k = 0; k < info.nlinks; ++k) {
    stop_if_interrupted();
    std::array<char, max_name> name{};
    if (H5Lget_name_by_idx(file_.get(), group.c_str(), H5_INDEX_NAME, H5_ITER_INC, k, name.data(),
                           name.size(), H5P_DEFAULT) < 0)
      refuse(fmt::format("its {} is damaged", group));
    names.emplace_back(name.data());
  }
  return names;
}

std::uint64_t Hdf5Reader::stored_bytes(const std::string& name) const {
  if (!find(name)) refuse(fmt::format("its {} is missing or damaged", name));
  const Hdf5Handle dataset(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  return dataset.get() < 0 ? 0 : H5Dget_storage_size(dataset.get());
}

Hdf5Handle Hdf5Reader::open(const std::string& name) const {
  if (!find(name)) refuse(fmt::format("its {} is missing or damaged", name));
  Hdf5Handle dataset(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (dataset.get() < 0) refuse(fmt::format("its {} is missing or damaged", name));
  check_storage(dataset, name);
  return dataset;
}

// Checks that the data lie in this file and are packed as in our files.
void Hdf5Reader::check_storage(const Hdf5Handle& dataset, const std::string& name) const {
  const Hdf5Handle plan(H5Dget_create_plist(dataset.get()), H5Pclose);
  const H5D_layout_t layout = H5Pget_layout(plan.get());
  if (layout == H5D_VIRTUAL || H5Pget_external_count(plan.get()) != 0)
    refuse(fmt::format("the data of its {} lie in another file", name),
           "a run file contains all of its data");
  if (layout < 0) refuse(fmt::format("its {} is missing or damaged", name));
  std::array<int, 3> found{};  // number of each of our filters
  for (int k = 0; k < H5Pget_nfilters(plan.get()); ++k) {
    const auto known = std::ranges::find(our_filters, filter_at(plan, k));
    const auto place = static_cast<std::size_t>(known - our_filters.begin());
    if (known == our_filters.end() || ++found.at(place) > 1)
      refuse(fmt::format("its {} is packed in another way", name));
  }
  if (layout == H5D_CHUNKED) check_pieces(dataset, plan, name, found[0] > 0);
}

// Checks that the pieces have sizes that ours can have, and unpack to no more than they state.
void Hdf5Reader::check_pieces(const Hdf5Handle& dataset, const Hdf5Handle& plan,
                              const std::string& name, bool is_packed) const {
  const std::vector<hsize_t> shape = shape_of(dataset, name);
  std::array<hsize_t, 2> piece{1, 1};
  const int count = H5Pget_chunk(plan.get(), 2, piece.data());
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose);
  if (count < 1 || count > 2 || piece[0] > max_piece || piece[1] > max_piece ||
      piece[0] * piece[1] * H5Tget_size(type.get()) > max_piece ||
      piece[0] < std::min(shape[0], min_piece))
    refuse(fmt::format("its {} is in pieces of another size", name));
  if (!is_packed) return;
  const std::size_t size = piece[0] * piece[1] * H5Tget_size(type.get());
  // Every piece takes room in the file.
  const hsize_t columns = count > 1 ? shape[1] : 1;
  const double pieces = (static_cast<double>(shape[0]) / static_cast<double>(piece[0]) + 1.0) *
                        (static_cast<double>(columns) / static_cast<double>(piece[1]) + 1.0);
  std::error_code ignored;
  if (pieces > static_cast<double>(std::filesystem::file_size(path_, ignored)))
    refuse(fmt::format("the shape of its {} is damaged", name));
  for (hsize_t row = 0; row < shape[0]; row += piece[0])
    for (hsize_t column = 0; column < columns; column += piece[1])
      check_piece(dataset, {row, column}, size, name);
}

// HDF5 unpacks without a limit. Small pieces need no check.
void Hdf5Reader::check_piece(const Hdf5Handle& dataset, const std::array<hsize_t, 2>& at,
                             std::size_t size, const std::string& name) const {
  stop_if_interrupted();
  unsigned skipped = 0;
  haddr_t address = 0;
  hsize_t stored = 0;
  constexpr std::size_t checksum = 4;
  if (H5Dget_chunk_info_by_coord(dataset.get(), at.data(), &skipped, &address, &stored) < 0 ||
      address == HADDR_UNDEF || stored <= small_piece)
    return;
  const auto refuse_it = [&] { refuse(fmt::format("its {} is damaged", name)); };
  if (stored > size + size / 16 + small_piece) refuse_it();
  if (skipped != 0) return;
  std::vector<std::uint8_t> bytes(stored);
  std::uint32_t mask = 0;
  if (H5Dread_chunk(dataset.get(), H5P_DEFAULT, at.data(), &mask, bytes.data()) < 0 ||
      !unpacks_within(bytes, size + checksum))
    refuse_it();
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

void Hdf5Reader::stop_if_interrupted() const {
  if (interrupted())
    throw Error(ErrorKind::interrupted,
                fmt::format("interrupted while '{}' was read", path_.string()));
}

void Hdf5Reader::read_rows(const std::string& name, const Hdf5Handle& dataset,
                           const std::vector<hsize_t>& begin, const std::vector<hsize_t>& extents,
                           hid_t type, void* into) const {
  const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
  const Hdf5Handle memory(
      H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, begin.data(), nullptr, extents.data(), nullptr);
  if (H5Dread(dataset.get(), type, memory.get(), space.get(), H5P_DEFAULT, into) < 0)
    refuse(fmt::format("its {} is damaged: {}", name, plain_cause()));
}

// Reads a few rows at a time, so that Ctrl-C takes effect in between.
template <class Number>
std::vector<Number> Hdf5Reader::part(const std::string& name, const Hdf5Handle& dataset,
                                     const std::vector<hsize_t>& extents, hid_t type) const {
  const Hdf5Handle stored(H5Dget_type(dataset.get()), H5Tclose);
  if (!is_number(stored.get())) refuse(fmt::format("its {} holds no numbers", name));
  std::size_t columns = 1;
  for (std::size_t k = 1; k < extents.size(); ++k) columns *= extents[k];
  std::vector<Number> values(columns * extents[0]);
  std::vector<hsize_t> begin(extents.size(), 0), piece = extents;
  for (hsize_t row = 0; row < extents[0]; row += piece[0]) {
    stop_if_interrupted();
    begin[0] = row;
    piece[0] = std::min(rows_at_once, extents[0] - row);
    read_rows(name, dataset, begin, piece, type, values.data() + columns * row);
  }
  return values;
}

Hdf5Handle Hdf5Reader::open_series(const std::string& name, hsize_t count) const {
  Hdf5Handle dataset = open(name);
  const std::vector<hsize_t> shape = shape_of(dataset, name);
  if (shape.size() != 1 || shape[0] < count)
    refuse(fmt::format("its {} is {}, expected {}", name, extents_text(shape), count));
  return dataset;
}

hsize_t Hdf5Reader::length(const std::string& name) const {
  const std::vector<hsize_t> shape = shape_of(open(name), name);
  if (shape.size() != 1) refuse(fmt::format("its {} is {}, no series", name, extents_text(shape)));
  return shape[0];
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

void Hdf5Reader::check_shape(const std::string& name, const std::vector<hsize_t>& shape) const {
  const Hdf5Handle dataset = open_shaped(name, shape);
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose);
  // Data that were never written take no space, and read as 0.
  if (H5Dget_storage_size(dataset.get()) * max_packed < shape[0] * H5Tget_size(type.get()))
    refuse(fmt::format("its {} has more rows than it has data", name));
}

std::vector<double> Hdf5Reader::first_doubles(const std::string& name, hsize_t count) const {
  const Hdf5Handle dataset = open_series(name, count);
  return part<double>(name, dataset, {count}, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> Hdf5Reader::first_integers(const std::string& name, hsize_t count) const {
  const Hdf5Handle dataset = open_series(name, count);
  return part<std::int64_t>(name, dataset, {count}, H5T_NATIVE_INT64);
}

std::string Hdf5Reader::first_texts(const std::string& name, hsize_t count,
                                    std::size_t length) const {
  const Hdf5Handle dataset = open_series(name, count);
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose);
  const bool fixed = H5Tget_class(type.get()) == H5T_STRING && H5Tis_variable_str(type.get()) == 0;
  if (!fixed || H5Tget_size(type.get()) != length)
    refuse(fmt::format("its {} holds no texts of {} characters", name, length));
  std::string all(count * length, '\0');
  read_rows(name, dataset, {0}, {count}, type.get(), all.data());
  return all;
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
