// SPDX-License-Identifier: MIT
#include "study/sharing.hpp"

#include <gmock/gmock.h>

namespace hackle {
namespace {

using testing::HasSubstr;

Outcome ran(const char* machine, int process, double began, double wall, bool taken_over = false) {
  Outcome outcome;
  outcome.made = {machine, process, "array 7", began, taken_over};
  outcome.wall = wall;
  return outcome;
}

TEST(Sharing, OneProcessAfterTheOtherSharesNothing) {
  Sharing sharing;
  sharing.add("a", ran("node1", 1, 100.0, 5.0));
  sharing.add("b", ran("node1", 1, 101.0, 5.0));  // side by side in one process
  sharing.add("c", ran("node1", 2, 107.0, 1.0));
  sharing.add("d", Outcome{});  // kept by a version that did not tell
  EXPECT_EQ(sharing.at_once(), 1);
  EXPECT_EQ(sharing.text(), "");
  EXPECT_TRUE(sharing.json().is_null());
}

TEST(Sharing, CountsProcessesMachinesAndTakenOverRuns) {
  Sharing sharing;
  sharing.add("a", ran("node1", 1, 100.0, 5.0));
  sharing.add("b", ran("node2", 1, 101.0, 1.0));
  sharing.add("c", ran("node2", 1, 102.0, 4.0, true));
  sharing.add("d", ran("node2", 2, 104.0, 1.0));
  sharing.add("a", ran("node1", 1, 100.0, 5.0));  // looked at twice
  EXPECT_EQ(sharing.at_once(), 3);
  EXPECT_THAT(sharing.text(),
              HasSubstr("4 runs by 3 processes on 2 machines (2, 1, 1), up to 3 at once\n"
                        "1 run taken over from processes that ended\n"));
  EXPECT_EQ(sharing.json()["processes"], 3);
  EXPECT_EQ(sharing.json()["runs"], nlohmann::ordered_json::array({2, 1, 1}));
}

TEST(Sharing, ARunEndsBeforeTheNextBegins) {
  Sharing sharing;
  sharing.add("a", ran("node1", 1, 100.0, 5.0));
  sharing.add("b", ran("node1", 2, 105.0, 5.0));
  EXPECT_EQ(sharing.at_once(), 1);
}

TEST(StudySession, HasWhatWasStartedTogether) {
  const StudySession alone(Launcher{});
  Provenance now = provenance_now("");
  EXPECT_TRUE(alone.includes(now));
  now.began -= 3.0;
  EXPECT_FALSE(alone.includes(now)) << "an earlier study";
  Launcher of_mpirun;
  of_mpirun.count = 2;
  of_mpirun.job = "mpi 1";
  now.job = "mpi 1";
  EXPECT_TRUE(StudySession(of_mpirun).includes(now)) << "a rank that started first";
  now.began -= 3600.0;
  EXPECT_FALSE(StudySession(of_mpirun).includes(now)) << "numbers recur";
  Launcher of_array;
  of_array.task = 3;
  of_array.job = "mpi 1";
  EXPECT_TRUE(StudySession(of_array).includes(now)) << "its tasks start when they may";
}

}  // namespace
}  // namespace hackle
