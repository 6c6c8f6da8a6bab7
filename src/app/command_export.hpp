// SPDX-License-Identifier: MIT
// hackle export RUN --csv | --vtk | --vtkhdf | --lammps
#pragma once

#include <filesystem>
#include <vector>

#include "output/export/export_choice.hpp"

namespace hackle {

enum class ExportKind { csv, vtk, vtkhdf, lammps };

struct ExportRequest {
  std::filesystem::path run;      // a run file or a checkpoint
  std::vector<ExportKind> kinds;  // one
  std::filesystem::path output;   // "": the name of the run with the ending of the kind
  ExportWishes wishes;
  bool quiet = false;
};

// Writes the states of a run, or its scene, for other programs. Returns the exit code.
int command_export(const ExportRequest& request);

}  // namespace hackle
