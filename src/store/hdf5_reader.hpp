// SPDX-License-Identifier: MIT
// Reads a run file. The file is not trusted: a dataset must have the requested shape, lie in the
// file itself, and take no more memory than the requested data.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "store/hdf5.hpp"

namespace hackle {

// Every function throws Error (files), which names the file and its fault but quotes none of its
// content; functions that read datasets throw Error (interrupted) on Ctrl-C. Links other than plain
// ones are refused, and so are data in other files.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& path);

  // Attributes of the root group.
  bool has_attribute(const std::string& name) const;
  std::int64_t integer(const std::string& name) const;
  std::string attribute(const std::string& name) const;  // at most 64 KiB

  // Datasets.
  bool holds(const std::string& name) const;
  // Returns the names in a group, in order; "/" is the root.
  std::vector<std::string> names(const std::string& group) const;
  // Returns the bytes of its data in the file; 0 for a group.
  std::uint64_t stored_bytes(const std::string& name) const;
  std::string text(const std::string& name) const;  // at most 64 MiB
  // Returns the number of values in a series.
  hsize_t length(const std::string& name) const;
  // Reads the first values of a series.
  std::vector<double> first_doubles(const std::string& name, hsize_t count) const;
  std::vector<std::int64_t> first_integers(const std::string& name, hsize_t count) const;
  // The same of texts that all have this length, one after the other.
  std::string first_texts(const std::string& name, hsize_t count, std::size_t length) const;
  // Reads the first columns of a dataset of this shape, row by row.
  std::vector<double> doubles(const std::string& name, const std::vector<hsize_t>& shape,
                              hsize_t columns) const;
  std::vector<std::uint32_t> words(const std::string& name,
                                   const std::vector<hsize_t>& shape) const;
  // Refuses a dataset of another shape, or with more data than the file can hold, without reading
  // it.
  void check_shape(const std::string& name, const std::vector<hsize_t>& shape) const;

  [[noreturn]] void refuse(const std::string& what, const std::string& remedy = {}) const;

 private:
  Hdf5Handle open(const std::string& name) const;
  bool find(const std::string& name) const;
  void check_link(const std::string& name) const;
  void check_storage(const Hdf5Handle& dataset, const std::string& name) const;
  void check_pieces(const Hdf5Handle& dataset, const Hdf5Handle& plan, const std::string& name,
                    bool is_packed) const;
  void check_piece(const Hdf5Handle& dataset, const std::array<hsize_t, 2>& at, std::size_t size,
                   const std::string& name) const;
  Hdf5Handle open_attribute(const std::string& name) const;
  Hdf5Handle open_series(const std::string& name, hsize_t count) const;
  Hdf5Handle open_shaped(const std::string& name, const std::vector<hsize_t>& shape) const;
  std::vector<hsize_t> shape_of(const Hdf5Handle& dataset, const std::string& name) const;
  std::string text_of(hid_t type, const std::string& name, std::size_t max, const auto& read) const;
  template <class Number>
  std::vector<Number> part(const std::string& name, const Hdf5Handle& dataset,
                           const std::vector<hsize_t>& extents, hid_t type) const;
  void read_rows(const std::string& name, const Hdf5Handle& dataset,
                 const std::vector<hsize_t>& begin, const std::vector<hsize_t>& extents, hid_t type,
                 void* into) const;
  void stop_if_interrupted() const;

  std::filesystem::path path_;
  Hdf5Handle file_;
};

}  // namespace hackle
