// SPDX-License-Identifier: MIT
// What of a plate the records of a run file hold.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "lattice/grid.hpp"
#include "measure/scalar.hpp"
#include "store/hdf5_reader.hpp"

namespace hackle {

// What records hold where nothing else is asked for: all that pictures need.
inline constexpr auto usual_records =
    std::to_array<std::string_view>({"damage", "displacement", "velocity", "bonds"});

// The names of what can be recorded: those, then the other fields of pictures. In a file
// "displacement" and "velocity" are vectors; "bonds" are all that are broken, with the thermal
// strain.
inline constexpr auto recordable_fields = [] {
  std::array<std::string_view, usual_records.size() + scalar_names.size() - 2> names;
  auto* next = std::copy(usual_records.begin(), usual_records.end(), names.begin());
  for (const std::string_view name : scalar_names)
    if (name != "damage" && name != "displacement") *next++ = name;
  return names;
}();

// A rectangle of nodes, of which every `stride`-th along x and y is taken: nx times ny of them,
// beginning with node (i, j).
struct NodeWindow {
  int i = 0, j = 0;
  int nx = 0, ny = 0;
  int stride = 1;

  std::size_t nodes() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  // Calls visit(i, j) for the nodes, row by row from the lower left.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int b = 0; b < ny; ++b)
      for (int a = 0; a < nx; ++a) visit(i + a * stride, j + b * stride);
  }
};

struct RecordContents {
  std::vector<std::string> fields;  // of recordable_fields
  NodeWindow nodes;
  bool part = false;   // not all nodes: no bonds, and no exact state but in the first record
  bool exact = false;  // the whole state in every record, and displacement and velocity in f64

  bool holds(std::string_view field) const;
};

// All nodes, with the standard fields.
RecordContents standard_contents(const Grid& grid);

// As JSON text.
std::string text_of(const RecordContents& contents);
// Of a run file; the standard contents in format 2. Throws Error (files) for a text of another form
// or that names a field or a node that does not exist.
RecordContents contents_of(const Hdf5Reader& file, const Grid& grid);

// Returns the lattice of these nodes alone.
Grid grid_of(const NodeWindow& nodes, const Grid& grid);

}  // namespace hackle
