// SPDX-License-Identifier: MIT
// The tables of a run in its run file, a copy of what its CSV files hold.
#pragma once

#include <span>

#include "store/hdf5.hpp"
#include "store/series_file.hpp"

namespace hackle {

// Writes /series/NAME/HEADING, a dataset of one f64 per row for every column of every table; NAME
// is that of the table's file, HEADING as in its head line, units included. NaN where a cell is
// empty. Tables of one name get a number behind it; a table without rows is left out. Throws Error
// (files).
void write_series(Hdf5File& file, std::span<const SeriesTable> tables);

}  // namespace hackle
