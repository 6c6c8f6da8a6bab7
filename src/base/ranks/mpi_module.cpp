// SPDX-License-Identifier: MIT
#include "base/ranks/mpi_module.hpp"

#include <filesystem>

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/ranks/launcher.hpp"

namespace hackle {
namespace {

std::filesystem::path module_path() {
  return this_program().parent_path().parent_path() / "lib" / "hackle" / "hackle_mpi.so";
}

}  // namespace

Ranks* find_ranks(double patience) {
  static Ranks* const found = [&]() -> Ranks* {
    if (this_launcher().count == 1) return nullptr;
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
    Ranks* ranks = entry(patience);
    return ranks->count() > 1 ? ranks : nullptr;  // tasks of Slurm may have nothing in common
  }();
  return found;
}

}  // namespace hackle
