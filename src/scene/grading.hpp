// SPDX-License-Identifier: MIT
// Materials that change from place to place, in levels.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/plate.hpp"

namespace hackle {

// Quantities of a material as functions of place. They are asked in the middle of square cells and
// rounded to levels; the cells of one level are an inclusion. A node takes the level of its cell.
struct Grading {
  // In the order of graded_names.
  static constexpr std::size_t quantities = 4;
  Material material;  // has all that is not graded
  Region region;
  std::array<std::optional<ScalarField>, quantities> fields;
  int levels = 16;    // of each quantity
  double cell = 0.0;  // m; 0: 1/400 of the longer side of the plate
};

// The last is a factor on the critical stretch.
inline constexpr std::array<std::string_view, Grading::quantities> graded_names{"E", "rho", "G0",
                                                                                "strength"};
inline constexpr std::array<std::string_view, Grading::quantities> graded_units{"Pa", "kg/m3",
                                                                                "J/m2", ""};

inline constexpr int most_levels = 254;
inline constexpr double most_cells = 4e6;

// Adds a problem for cells that are too many, and if nothing is graded.
void check(const Plate& plate, const Grading& grading, Problems& problems);

// Returns the levels as inclusions, each with the middle of what its cells had; those of the same
// rounded quantities are one. Throws Error (refused) for a value that is not above 0, and for more
// than most_levels of them.
std::vector<Inclusion> make(const Plate& plate, const Grading& grading);

}  // namespace hackle
