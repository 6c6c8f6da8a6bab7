// SPDX-License-Identifier: MIT
// What mpirun, srun or a job array tells a program that it starts many times, in the environment.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace hackle {

// The place of this process among those that were started together.
struct Launcher {
  int rank = 0;         // 0 .. count - 1, of the processes that run side by side
  int count = 1;        // of these
  int local_count = 1;  // of these on this machine
  int task = -1;        // the index of the task in its job array; -1: not in a job array
  int tasks = 1;        // of the job array
  std::string job;      // the same text for all that were started together; "": not told

  bool is_in_array() const { return task >= 0; }
  bool is_alone() const { return count == 1 && !is_in_array(); }
};

// Returns the value of an environment variable, or null.
using EnvironmentLookup = std::function<const char*(const char* name)>;

// Reads OMPI_COMM_WORLD_RANK (Open MPI), PMIX_RANK, PMI_RANK (MPICH, Intel MPI) or SLURM_PROCID of
// a step of srun, the first that is set, with the sizes that belong to it, and SLURM_ARRAY_TASK_ID.
// A value that is no number counts as not set.
Launcher launcher_of(const EnvironmentLookup& variable);

// Returns the same of this process.
Launcher this_launcher();

// Returns how many threads one of `local_count` processes should have that started together on a
// machine of so many cores, `allowed` of which this process may run on: at least 1.
int share_of_cores(int local_count, int allowed, int cores);
// Returns the same of this process and machine.
int share_of_cores(const Launcher& launcher);

// Returns whether an environment variable tells a process its place among others. A program that
// such a process starts has no place, and must not see it.
bool is_of_launcher(std::string_view name);

}  // namespace hackle
