// SPDX-License-Identifier: MIT
// A field of nodes as a file.
#pragma once

#include <filesystem>
#include <string>

#include "measure/node_values.hpp"

namespace hackle {

// Writes a table with a row for every node that is not in a hole: x_m, y_m and the value, under the
// name of the field with its unit, as in heading_of(). Throws Error (files).
void write_values(const NodeValues& values, const std::filesystem::path& path);

// Writes a PNG with one pixel for each node, transparent in holes, in colours from the smallest
// value to the largest: what is measured, without interpolation, legend or lines. Throws Error
// (files).
void write_values_image(const NodeValues& values, const std::string& colours,
                        const std::filesystem::path& path);

}  // namespace hackle
