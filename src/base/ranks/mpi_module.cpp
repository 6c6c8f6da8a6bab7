// SPDX-License-Identifier: MIT
#include "base/ranks/mpi_module.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/child_process.hpp"
#include "base/error.hpp"

namespace hackle {
namespace {

// Set by Open MPI and by launchers of PMI (MPICH, srun --mpi=pmi2).
constexpr std::array sizes{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};

int number_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 0 : std::atoi(text);
}

std::filesystem::path module_path() {
  return this_program().parent_path().parent_path() / "lib" / "hackle" / "hackle_mpi.so";
}

}  // namespace

bool is_started_by_mpi() {
  // Slurm's own tasks are none of MPI unless it speaks PMIx to them (srun --mpi=pmix).
  if (std::getenv("PMIX_RANK") != nullptr && number_in("SLURM_NTASKS") > 1) return true;
  return std::ranges::any_of(sizes, [](const char* name) { return number_in(name) > 1; });
}

Ranks* find_ranks(double patience) {
  static Ranks* const found = [&]() -> Ranks* {
    if (!is_started_by_mpi()) return nullptr;
    const std::filesystem::path path = module_path();
    // Global, since Open MPI loads parts of its own that expect its symbols.
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    const auto entry = module == nullptr
                           ? nullptr
                           : reinterpret_cast<MpiModuleEntry>(dlsym(module, mpi_module_entry));
    if (entry == nullptr)
      throw Error(
          ErrorKind::refused,
          fmt::format("mpirun started this program, but its part for MPI cannot be loaded: {}",
                      dlerror()),
          "build it with Open MPI installed (libopenmpi-dev), or start it without mpirun");
    return entry(patience);
  }();
  return found;
}

}  // namespace hackle
