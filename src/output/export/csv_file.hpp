// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/export_choice.hpp"

namespace hackle {

// Writes a table with a row per node and time: time (s), x (m), y (m), then the fields, a column
// per component. Its first line names the columns with their units. Nodes that are cut out are left
// out. Fields
// read back as they were, times and places to twelve digits. Throws Error (files), Error
// (interrupted).
void write_csv(
    StoredRun& run, const ExportChoice& choice, const std::filesystem::path& path,
    const ShareDone& done = [](double) {});

}  // namespace hackle
