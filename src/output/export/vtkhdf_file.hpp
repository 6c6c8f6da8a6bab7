// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/export_choice.hpp"

namespace hackle {

// Writes a VTKHDF file (version 2.0 of the format, which VTK 9.3 and ParaView 5.12 read): the nodes
// as an UnstructuredGrid of vertices, which all times share, their fields as point data, time by
// time, and the group Steps, which says where each begins. A file of one time has no Steps and is
// of version 1.0, which VTK 9.1 reads too. Throws Error (files), Error (interrupted).
void write_vtkhdf(
    StoredRun& run, const ExportChoice& choice, const std::filesystem::path& path,
    const ShareDone& done = [](double) {});

}  // namespace hackle
