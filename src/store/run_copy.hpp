// SPDX-License-Identifier: MIT
// The first records of a run file, as a file to which others are added.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "store/hdf5.hpp"

namespace hackle {

// A killed program leaves every committed record whole, but nothing else of its file can be relied
// on: it cannot be written further. So all that belongs to the first `records` records is copied,
// as it is, without unpacking it; the copy then takes the name, and is returned to be gone on with.
// The file is not complete, its series /time, /step and the like have as many values, and nothing
// of later records is left. Throws Error (files), with a remedy, if `path` is no run file of this
// format, has another number of nodes, or fewer records; it is then unchanged.
Hdf5File first_records(const std::filesystem::path& path, int format, std::size_t nodes,
                       std::int64_t records);

}  // namespace hackle
