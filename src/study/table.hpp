// SPDX-License-Identifier: MIT
// A table of texts: for a person, and as CSV.
#pragma once

#include <string>
#include <vector>

namespace hackle {

struct Table {
  std::vector<std::string> heads;              // with units: "wall (s)"
  std::vector<std::vector<std::string>> rows;  // each as long as the heads
};

// Returns lines with the columns below each other: the first and the last to the left, the others
// to the right.
std::string aligned(const Table& table);

// Returns CSV after RFC 4180.
std::string csv_of(const Table& table);

}  // namespace hackle
