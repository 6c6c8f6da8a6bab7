// SPDX-License-Identifier: MIT
// A run file being read. Nothing in it is believed: a dataset must have the shape asked for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "store/hdf5.hpp"

namespace hackle {

// Every function throws Error (files), naming the file and what is wrong with it.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& path);

  // Attributes of the root.
  bool has_attribute(const std::string& name) const;
  std::int64_t integer(const std::string& name) const;
  std::string attribute(const std::string& name) const;

  // Datasets.
  bool holds(const std::string& name) const;
  std::string text(const std::string& name) const;
  // How many rows a dataset of so many columns has; at most 1e6.
  hsize_t rows(const std::string& name, hsize_t columns) const;
  // The first of a series.
  std::vector<double> first_doubles(const std::string& name, hsize_t count) const;
  std::vector<std::int64_t> first_integers(const std::string& name, hsize_t count) const;
  // A dataset of this shape, of its columns the first ones. Row by row.
  std::vector<double> doubles(const std::string& name, const std::vector<hsize_t>& shape,
                              hsize_t columns) const;
  std::vector<std::uint32_t> words(const std::string& name,
                                   const std::vector<hsize_t>& shape) const;

  [[noreturn]] void refuse(const std::string& what, const std::string& remedy = {}) const;

 private:
  Hdf5Handle open(const std::string& name) const;
  Hdf5Handle open_series(const std::string& name, hsize_t count) const;
  Hdf5Handle open_shaped(const std::string& name, const std::vector<hsize_t>& shape) const;
  std::vector<hsize_t> shape_of(const Hdf5Handle& dataset, const std::string& name) const;
  std::string text_of(hid_t type, const std::string& name, const auto& read) const;
  template <class Number>
  std::vector<Number> part(const std::string& name, const Hdf5Handle& dataset,
                           const std::vector<hsize_t>& extents, hid_t type) const;

  std::filesystem::path path_;
  Hdf5Handle file_;
};

}  // namespace hackle
