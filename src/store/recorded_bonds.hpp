// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "lattice/lattice.hpp"
#include "store/hdf5_reader.hpp"

namespace hackle {

// Clears the bonds that are broken in the record in that group. Throws Error (files).
void break_recorded(const Hdf5Reader& file, const std::string& group, const Lattice& lattice,
                    BondBits& bonds);

}  // namespace hackle
