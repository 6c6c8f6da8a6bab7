// SPDX-License-Identifier: MIT
// Ranks of MPI, in a module that is loaded where mpirun started the program: without it no MPI
// library is needed, or loaded.
#pragma once

#include "base/ranks/ranks.hpp"

namespace hackle {

// Name of the function that the module exports: `extern "C" Ranks* hackle_mpi_ranks(double
// patience)`. A rank that waits for more than `patience` seconds ends all; 0: waits for ever.
inline constexpr const char* mpi_module_entry = "hackle_mpi_ranks";
using MpiModuleEntry = Ranks* (*)(double patience);

// Returns the ranks that this process is one of, or nullptr if it is alone. They live until the
// process ends. Throws Error (refused) if the module is not installed or cannot be loaded.
Ranks* find_ranks(double patience);

}  // namespace hackle
