// SPDX-License-Identifier: MIT
// The fragments of a plate as a table.
#pragma once

#include <filesystem>

#include "measure/fragment_list.hpp"

namespace hackle {

// Writes CSV with a row for each fragment, the largest first, so that `number` over `area_m2` is
// the cumulative distribution of sizes and `passing` what a sieve tells. Throws Error (files).
void write_fragments(const FragmentList& fragments, const std::filesystem::path& path);

}  // namespace hackle
