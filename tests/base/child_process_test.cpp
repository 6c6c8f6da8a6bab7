// SPDX-License-Identifier: MIT
#include "base/child_process.hpp"

#include <csignal>
#include <cstdlib>
#include <limits>
#include <optional>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/file_lock.hpp"
#include "base/interrupt.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

ChildResult shell(const std::string& text, double time_limit = 60.0) {
  return run_child({"/bin/sh", "-c", text}, time_limit);
}

TEST(ChildProcess, TellsWhatAProgramPrintsAndHowItEnds) {
  const ChildResult result = shell("echo out; echo err >&2; exit 3");
  EXPECT_EQ(result.out, "out\n");
  EXPECT_EQ(result.error, "err\n");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_FALSE(result.succeeded());
  EXPECT_GT(result.peak_bytes, 0U);
}

TEST(ChildProcess, KeepsAllOfALongOutput) {
  const ChildResult result = shell("head -c 3000000 /dev/zero | tr '\\0' x");
  EXPECT_EQ(result.out.size(), 3000000U);
  EXPECT_TRUE(result.succeeded());
}

TEST(ChildProcess, KeepsTheEndOfManyMessages) {
  const ChildResult result = shell("head -c 100000 /dev/zero | tr '\\0' x >&2; echo end >&2");
  EXPECT_EQ(result.error.size(), 16384U);
  EXPECT_TRUE(result.error.ends_with("xend\n"));
}

TEST(ChildProcess, IsKilledWhenItsTimeIsUp) {
  const ChildResult result = shell("exec sleep 60", 0.1);
  EXPECT_TRUE(result.timed_out);
  EXPECT_EQ(result.exit_code, 128 + SIGKILL);
  EXPECT_LT(result.wall, 30.0);
}

TEST(ChildProcess, CountsOnlyTheTimeThatItComputes) {
  const ChildResult result = shell("exec sleep 0.3");
  EXPECT_GE(result.wall, 0.3);
  EXPECT_LT(result.cpu, 0.3);
}

TEST(ChildProcess, HasNothingToRead) {
  EXPECT_EQ(shell("cat; echo done").out, "done\n");
}

TEST(ChildProcess, TellsWhichProgramThereIsNot) {
  EXPECT_THROW(run_child({"/nowhere/program"}), Error);
  EXPECT_THROW(run_child({}), Error);
}

TEST(ChildProcess, EndsWhenItIsInterrupted) {
  request_interrupt();
  EXPECT_THROW(shell("exec sleep 60"), Error);
  clear_interrupt();
}

TEST(ChildProcess, DoesNotSeeThePlaceOfItsParent) {
  setenv("OMPI_COMM_WORLD_RANK", "3", 1);
  setenv("SLURM_ARRAY_TASK_ID", "4", 1);
  setenv("HACKLE_SEEN", "5", 1);
  const ChildResult result = shell("echo $OMPI_COMM_WORLD_RANK-$SLURM_ARRAY_TASK_ID-$HACKLE_SEEN");
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "SLURM_ARRAY_TASK_ID", "HACKLE_SEEN"})
    unsetenv(name);
  EXPECT_EQ(result.out, "--5\n");
}

TEST(ChildProcess, HoldsALockThatItInherits) {
  const test::Folder folder;
  const auto file = folder.path / "lock";
  std::optional<ChildProcess> child;
  {
    const FileLock lock(file, true);
    ASSERT_TRUE(lock.is_held());
    child.emplace(std::vector<std::string>{"/bin/sleep", "60"},
                  std::numeric_limits<double>::infinity(), lock.descriptor());
  }
  EXPECT_TRUE(is_locked(file)) << "the child lives";
  child.reset();
  EXPECT_FALSE(is_locked(file));
}

TEST(ChildProcess, TwoRunAtOnce) {
  ChildProcess one({"/bin/sh", "-c", "sleep 0.05; echo 1"}), other({"/bin/sh", "-c", "echo 2"});
  std::optional<ChildResult> first, second;
  while (!first || !second) {
    if (!first) first = one.poll();
    if (!second) second = other.poll();
  }
  EXPECT_EQ(first->out, "1\n");
  EXPECT_EQ(second->out, "2\n");
}

}  // namespace
}  // namespace hackle
