// SPDX-License-Identifier: MIT
// The XDMF sidecar of a run file: tells ParaView 5.11 and VTK where the data lie in the HDF5 file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "lattice/grid.hpp"

namespace hackle {

struct RecordContents;

// The group of a record in the run file, e.g. "records/1/01234": one group per thousand records.
inline constexpr std::size_t records_a_group = 1000;
inline constexpr unsigned max_record_groups = 1000;
std::string record_group(std::size_t record);

// Throws Error (refused) for a run file name that ParaView's readers cannot handle: they take the
// text before a ':' for the file, join parts at '|' and cut off blanks at the ends; the text must
// be UTF-8 without control characters.
void check_name(const std::filesystem::path& run_file);

// A field of every record.
struct SidecarField {
  std::string name;
  int components = 1;  // in the file: 1 or 3
  int precision = 4;   // bytes of a number
};
std::vector<SidecarField> standard_sidecar();
std::vector<SidecarField> sidecar_fields(const RecordContents& contents);

// Returns the XML for the records at these times (s). The nodes are the points of an image, so that
// ParaView at once shows a coloured surface and can warp it by the displacement.
std::string xdmf(const Grid& grid, const std::filesystem::path& run_file,
                 const std::vector<double>& times, bool has_material = false,
                 const std::vector<SidecarField>& fields = standard_sidecar());

}  // namespace hackle
