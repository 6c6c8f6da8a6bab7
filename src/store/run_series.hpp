// SPDX-License-Identifier: MIT
// The tables of a run in its run file, a copy of what its CSV files hold.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "store/hdf5.hpp"
#include "store/series_file.hpp"

namespace hackle {

// Writes /series/NAME/HEADING, a dataset of one f64 per row for every column of every table; NAME
// is that of the table's file, HEADING as in its head line, units included. NaN where a cell is
// empty. Tables of one name get a number behind it; a table without rows is left out. Throws Error
// (files).
void write_series(Hdf5File& file, std::span<const SeriesTable> tables);

// Returns the tables in a run file; none before its run has ended. Throws Error (files) for one
// that is damaged, Error (interrupted).
std::vector<SeriesTable> series_in(const std::filesystem::path& run_file);

}  // namespace hackle
