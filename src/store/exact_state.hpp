// SPDX-License-Identifier: MIT
// The state of a record to the last bit, from which a simulation goes on: the arrays that
// for_each_dataset() adds, and RECORD/state, a text in JSON with the rest (snapshot_head.hpp).
#pragma once

#include <string>

#include "solver/simulation.hpp"
#include "store/hdf5_reader.hpp"

namespace hackle {

std::string exact_head(const Simulation& simulation);

bool holds_exact_state(const Hdf5Reader& file, const std::string& group);

// The state is that after the step of the record, which the record may show up to a step earlier.
// Throws Error (files) for one that is damaged or not of this lattice.
Snapshot read_exact_state(const Hdf5Reader& file, const std::string& group, const Lattice& lattice);

}  // namespace hackle
