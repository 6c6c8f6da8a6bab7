// SPDX-License-Identifier: MIT
// Ranks that fail, hang, are killed or go astray end together, with a reason.
#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ranks/mpirun.hpp"

namespace hackle::test {
namespace {

using testing::HasSubstr;

constexpr const char* plate = R"(
local p = plate { width = 60*mm, height = 40*mm, material = "duran50" }
p:traction { edge = "top", stress = {0, 2*MPa} }
local s = simulate(p, { spacing = 0.5*mm })
)";

TEST(RanksWithFaults, ErrorsOfAllAreSaidOnce) {
  HACKLE_NEEDS_MPI;
  const Folder folder;
  write(folder, "bad.lua", std::string(plate) + "s:run(-1*us)\n");
  const Said said = hackle(folder, 3, "run -j 1 bad.lua");
  const Said alone = hackle(folder, 1, "run -j 1 bad.lua");
  EXPECT_EQ(said.code, alone.code);
  const std::string line = alone.err.substr(alone.err.find("error:"), 30);
  const std::size_t first = said.err.find(line);
  ASSERT_NE(first, std::string::npos) << said.err;
  EXPECT_EQ(said.err.find(line, first + 1), std::string::npos) << said.err;
}

TEST(RanksWithFaults, TooManyAreRefusedWithTheMostThatServe) {
  HACKLE_NEEDS_MPI;
  const Folder folder;
  write(folder, "thin.lua",
        "local p = plate { width = 60*mm, height = 10*mm, material = \"duran50\" }\n"
        "simulate(p, { spacing = 0.5*mm })\n");
  const Said said = hackle(folder, 4, "run -j 1 thin.lua");
  EXPECT_EQ(said.code, 4);
  EXPECT_THAT(said.err, HasSubstr("at most 2 ranks"));
}

TEST(RanksWithFaults, AScriptThatGoesAstrayIsStoppedWithTheCall) {
  HACKLE_NEEDS_MPI;
  const Folder folder;
  write(folder, "astray.lua",
        std::string(plate) +
            "local rank = tonumber(os.getenv and os.getenv(\"OMPI_COMM_WORLD_RANK\") or 0)\n"
            "s:run(1*us) s:run((2 + rank)*us) s:run(1*us)\n");
  const Said said = hackle(folder, 3, "run --trust -j 1 astray.lua");
  EXPECT_EQ(said.code, 1);
  EXPECT_THAT(said.err, HasSubstr("the ranks have diverged"));
  EXPECT_THAT(said.err, HasSubstr("rank 0 calls s:run(2e-06)"));
  EXPECT_THAT(said.err, HasSubstr("rank 1 s:run(3e-06)"));
}

TEST(RanksWithFaults, ARankThatFailsAloneEndsTheOthersAndSaysWhy) {
  HACKLE_NEEDS_MPI;
  const Folder folder;
  write(folder, "alone.lua",
        std::string(plate) +
            "s:run(1*us)\n"
            "if os.getenv(\"OMPI_COMM_WORLD_RANK\") == \"0\" then error(\"only here\") end\n"
            "s:run(50*us)\n");
  const Said said = hackle(folder, 3, "run --trust -j 1 alone.lua");
  EXPECT_NE(said.code, 0);
  EXPECT_THAT(said.err, HasSubstr("only here"));
  EXPECT_THAT(said.err, HasSubstr("while others went on"));
}

// The process of the last rank is stopped, or killed, in the middle of a run.
Said run_with(const Folder& folder, const std::string& signal) {
  write(folder, "long.lua",
        std::string(plate) + "s:run(2*us) print(\"go\") io.stdout:flush() s:run(1)\n");
  return shell(
      folder,
      fmt::format(
          "mpirun --allow-run-as-root --oversubscribe -n 3 \"{}\" run -j 1 "
          "--rank-timeout 3 --checkpoint 0.5s --trust long.lua & "
          "for n in $(seq 200); do sleep 0.1; ls out/long/*.ckpt >/dev/null 2>&1 && break; done; "
          "kill -{} $(pgrep -P $(pgrep -P $$ mpirun | head -1) | tail -1); wait $!",
          HACKLE_PROGRAM, signal));
}

TEST(RanksWithFaults, AKilledRankEndsTheRunAndLeavesACheckpoint) {
  HACKLE_NEEDS_MPI;
  const Folder folder;
  const auto start = std::chrono::steady_clock::now();
  const Said said = run_with(folder, "KILL");
  EXPECT_NE(said.code, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60)) << "it went on";
  // The words are mpirun's, which names the signal only where it hears of it before the others end.
  EXPECT_THAT(said.err, testing::AnyOf(HasSubstr("Killed"), HasSubstr("the job has been aborted")));
  const Said kept =
      shell(folder, fmt::format("\"{}\" info out/long/long.auto.ckpt", HACKLE_PROGRAM));
  EXPECT_EQ(kept.code, 0) << kept.err;
}

TEST(RanksWithFaults, ARankThatHangsIsNamed) {
  HACKLE_NEEDS_MPI;
  const Folder folder;
  const Said said = run_with(folder, "STOP");
  EXPECT_NE(said.code, 0);
  EXPECT_THAT(said.err, HasSubstr("s for rank 2, which hangs"));
  shell(folder, "pkill -KILL -f long.lua");
}

}  // namespace
}  // namespace hackle::test
