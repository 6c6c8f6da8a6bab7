// SPDX-License-Identifier: MIT
// The last states of the ways of a trade, side by side.
#pragma once

#include <filesystem>

#include "study/trade.hpp"

namespace hackle {

// Runs the reference, the script as written and what is recommended once more, for a picture of the
// last state, and places the pictures on a sheet with their error and cost. Throws what CaseRunner
// throws, and Error (files).
void write_sheet(CaseRunner& runner, const Trade& trade, const std::filesystem::path& path);

}  // namespace hackle
