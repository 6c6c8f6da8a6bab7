// SPDX-License-Identifier: MIT
#include "base/ranks/launcher.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>

#include <unistd.h>

#include "base/machine.hpp"

namespace hackle {
namespace {

std::string launcher_text(const EnvironmentLookup& variable, const char* name) {
  const char* value = variable(name);
  return value == nullptr ? "" : value;
}

std::optional<int> launcher_number(const EnvironmentLookup& variable, const char* name) {
  const std::string value = launcher_text(variable, name);
  int number = 0;
  const auto [end, failed] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool whole = failed == std::errc() && end == value.data() + value.size();
  return whole && number >= 0 ? std::optional(number) : std::nullopt;
}

// The first of the variables that is a number.
std::optional<int> first_number(const EnvironmentLookup& variable,
                                std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto number = launcher_number(variable, name)) return number;
  return std::nullopt;
}

// A batch script of Slurm has SLURM_PROCID too, but is no step of many.
bool is_step_of_slurm(const EnvironmentLookup& variable) {
  return launcher_number(variable, "SLURM_STEP_NUM_TASKS").has_value();
}

std::optional<int> rank_of(const EnvironmentLookup& variable) {
  const auto rank = first_number(variable, {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"});
  return rank || !is_step_of_slurm(variable) ? rank : launcher_number(variable, "SLURM_PROCID");
}

int local_count_of(const EnvironmentLookup& variable, int count) {
  const auto told = first_number(variable, {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"});
  const int machines = first_number(variable, {"SLURM_STEP_NUM_NODES"}).value_or(count);
  const int shared = (count + std::max(machines, 1) - 1) / std::max(machines, 1);
  return std::clamp(told.value_or(shared), 1, count);
}

std::string job_of(const EnvironmentLookup& variable, bool is_in_array) {
  const std::string array = launcher_text(variable, "SLURM_ARRAY_JOB_ID");
  if (is_in_array && !array.empty()) return "array " + array;
  for (const char* name : {"PMIX_NAMESPACE", "OMPI_MCA_ess_base_jobid"})
    if (const std::string job = launcher_text(variable, name); !job.empty()) return "mpi " + job;
  if (!is_step_of_slurm(variable)) return "";
  return "step " + launcher_text(variable, "SLURM_JOB_ID") + "." +
         launcher_text(variable, "SLURM_STEP_ID");
}

}  // namespace

Launcher launcher_of(const EnvironmentLookup& variable) {
  Launcher launcher;
  if (const auto rank = rank_of(variable)) {
    const auto count =
        first_number(variable, {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"});
    launcher.rank = *rank;
    launcher.count = std::max(count.value_or(1), *rank + 1);
    launcher.local_count = local_count_of(variable, launcher.count);
  }
  if (const auto task = launcher_number(variable, "SLURM_ARRAY_TASK_ID")) {
    launcher.task = *task;
    launcher.tasks = std::max(launcher_number(variable, "SLURM_ARRAY_TASK_COUNT").value_or(1), 1);
  }
  if (!launcher.is_alone()) launcher.job = job_of(variable, launcher.is_in_array());
  return launcher;
}

Launcher this_launcher() {
  return launcher_of([](const char* name) { return std::getenv(name); });
}

// A launcher may have bound its processes to cores, each to its own or several to the same.
int share_of_cores(int local_count, int allowed, int cores) {
  return std::min(allowed, std::max(1, cores / local_count));
}

int share_of_cores(const Launcher& launcher) {
  const int allowed = available_cores();
  if (launcher.local_count == 1) return allowed;
  return share_of_cores(launcher.local_count, allowed,
                        static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN)));
}

bool is_of_launcher(std::string_view name) {
  constexpr std::array<std::string_view, 9> beginnings{"OMPI_",     "PMIX_",        "PMI_",
                                                       "PMI2_",     "PRTE_",        "HYDI_",
                                                       "MPI_LOCAL", "SLURM_ARRAY_", "SLURM_STEP_"};
  constexpr std::array<std::string_view, 5> names{"SLURM_PROCID", "SLURM_LOCALID", "SLURM_NODEID",
                                                  "SLURM_STEPID", "SLURM_GTIDS"};
  return std::ranges::find(names, name) != names.end() ||
         std::ranges::any_of(beginnings, [&](auto start) { return name.starts_with(start); });
}

}  // namespace hackle
