// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/export_choice.hpp"

namespace hackle {

// Writes a legacy VTK file (version 3.0, text) per chosen time: the nodes as points of PolyData,
// each a vertex, with their fields as point data and the time as field data TIME. One time goes to
// `path`, several to a/run_0000.vtk, a/run_0001.vtk, ... for "a/run.vtk", which ParaView opens as
// one series. Returns the files. Throws Error (files), Error (interrupted).
std::vector<std::filesystem::path> write_vtk(
    StoredRun& run, const ExportChoice& choice, const std::filesystem::path& path,
    const ShareDone& done = [](double) {});

}  // namespace hackle
