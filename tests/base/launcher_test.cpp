// SPDX-License-Identifier: MIT
#include "base/ranks/launcher.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace hackle {
namespace {

Launcher launched(const std::map<std::string, std::string>& variables) {
  return launcher_of([&](const char* name) {
    const auto at = variables.find(name);
    return at == variables.end() ? nullptr : at->second.c_str();
  });
}

TEST(Launcher, AProcessByItselfIsAlone) {
  const Launcher launcher = launched({{"HOME", "/root"}});
  EXPECT_TRUE(launcher.is_alone());
  EXPECT_EQ(launcher.rank, 0);
  EXPECT_EQ(launcher.job, "");
}

TEST(Launcher, ReadsWhatOpenMpiTells) {
  const Launcher launcher = launched({{"OMPI_COMM_WORLD_RANK", "5"},
                                      {"OMPI_COMM_WORLD_SIZE", "8"},
                                      {"OMPI_COMM_WORLD_LOCAL_SIZE", "4"},
                                      {"PMIX_RANK", "5"},
                                      {"PMIX_NAMESPACE", "21561345"}});
  EXPECT_EQ(launcher.rank, 5);
  EXPECT_EQ(launcher.count, 8);
  EXPECT_EQ(launcher.local_count, 4);
  EXPECT_EQ(launcher.job, "mpi 21561345");
  EXPECT_FALSE(launcher.is_in_array());
  EXPECT_FALSE(launcher.is_alone());
}

TEST(Launcher, ReadsWhatMpichTells) {
  const Launcher launcher =
      launched({{"PMI_RANK", "1"}, {"PMI_SIZE", "2"}, {"MPI_LOCALNRANKS", "2"}});
  EXPECT_EQ(launcher.rank, 1);
  EXPECT_EQ(launcher.count, 2);
  EXPECT_EQ(launcher.local_count, 2);
}

TEST(Launcher, ReadsAStepOfSlurm) {
  const Launcher launcher = launched({{"SLURM_PROCID", "6"},
                                      {"SLURM_STEP_NUM_TASKS", "7"},
                                      {"SLURM_STEP_NUM_NODES", "2"},
                                      {"SLURM_JOB_ID", "90"},
                                      {"SLURM_STEP_ID", "3"}});
  EXPECT_EQ(launcher.rank, 6);
  EXPECT_EQ(launcher.count, 7);
  EXPECT_EQ(launcher.local_count, 4);
  EXPECT_EQ(launcher.job, "step 90.3");
}

TEST(Launcher, ABatchScriptOfSlurmIsOneProcess) {
  EXPECT_TRUE(
      launched({{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "64"}, {"SLURM_JOB_ID", "9"}}).is_alone());
}

TEST(Launcher, ReadsATaskOfAJobArray) {
  const Launcher launcher = launched({{"SLURM_ARRAY_TASK_ID", "12"},
                                      {"SLURM_ARRAY_TASK_COUNT", "20"},
                                      {"SLURM_ARRAY_JOB_ID", "77"},
                                      {"SLURM_PROCID", "0"}});
  EXPECT_TRUE(launcher.is_in_array());
  EXPECT_EQ(launcher.task, 12);
  EXPECT_EQ(launcher.tasks, 20);
  EXPECT_EQ(launcher.rank, 0);
  EXPECT_EQ(launcher.job, "array 77");
}

TEST(Launcher, WhatIsNoNumberIsNotSet) {
  EXPECT_TRUE(launched({{"OMPI_COMM_WORLD_RANK", "two"}, {"SLURM_ARRAY_TASK_ID", ""}}).is_alone());
  EXPECT_TRUE(launched({{"PMI_RANK", "-1"}}).is_alone());
  EXPECT_EQ(launched({{"PMI_RANK", "3"}, {"PMI_SIZE", "2"}}).count, 4);
}

TEST(Launcher, CoresAreShared) {
  EXPECT_EQ(share_of_cores(1, 8, 8), 8);
  EXPECT_EQ(share_of_cores(3, 8, 8), 2) << "not bound";
  EXPECT_EQ(share_of_cores(16, 32, 64), 4) << "bound to a socket with eight others";
  EXPECT_EQ(share_of_cores(4, 1, 4), 1) << "bound to a core";
  EXPECT_EQ(share_of_cores(6, 2, 2), 1) << "more processes than cores";
}

TEST(Launcher, ItsVariablesAreThoseThatTellAPlace) {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_NAMESPACE", "PMI_RANK", "SLURM_PROCID",
                           "SLURM_ARRAY_TASK_ID", "SLURM_STEP_NUM_TASKS", "MPI_LOCALNRANKS"})
    EXPECT_TRUE(is_of_launcher(name)) << name;
  for (const char* name : {"PATH", "HACKLE_DATA", "SLURM_JOB_ID", "SLURM_CPUS_PER_TASK", "TMPDIR"})
    EXPECT_FALSE(is_of_launcher(name)) << name;
}

}  // namespace
}  // namespace hackle
