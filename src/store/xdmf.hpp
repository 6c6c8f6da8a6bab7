// SPDX-License-Identifier: MIT
// The XDMF sidecar of a run file: tells ParaView 5.11 and VTK where in the HDF5 file things are.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "lattice/grid.hpp"

namespace hackle {

// The group of a record in the run file, e.g. "records/1/01234": a group for every thousand.
inline constexpr std::size_t records_a_group = 1000;
std::string record_group(std::size_t record);

// Throws Error (refused) for the name of a run file that the readers of ParaView cannot follow:
// they take what stands before a ':' for the file and join parts at '|', cut blanks off at the
// ends, and the text must be UTF-8 without control characters.
void check_name(const std::filesystem::path& run_file);

// The XML for the records at these times (s). The nodes are the points of an image, so that
// ParaView shows a coloured surface at once and can warp it by the displacement.
std::string xdmf(const Grid& grid, const std::filesystem::path& run_file,
                 const std::vector<double>& times, bool has_material = false);

}  // namespace hackle
