// SPDX-License-Identifier: MIT
// The envelope of stability: what becomes of scenes at the extremes, each in a program of its own.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "study/case_runner.hpp"
#include "study/envelope_cells.hpp"
#include "study/envelope_verdict.hpp"

namespace hackle {

struct CellResult {
  EnvelopeCell cell;
  CellVerdict verdict;
  double seconds = 0.0;  // wall time
};

struct EnvelopeOptions {
  std::filesystem::path program;  // hackle
  std::filesystem::path scripts;  // the folder of the families
  RunnerOptions runner;           // its folder gets one folder for each family
};

// Runs the cells, heavy ones last and alone, and returns their results in the same order. Throws
// what CaseRunner throws. Who has run them is added to `sharing`.
std::vector<CellResult> run_envelope(const std::vector<EnvelopeCell>& cells,
                                     const EnvelopeOptions& options, Sharing& sharing);

// Returns how many ended so.
std::size_t count(const std::vector<CellResult>& results, CellEnd end);

}  // namespace hackle
