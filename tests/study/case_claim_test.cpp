// SPDX-License-Identifier: MIT
#include "study/case_claim.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <optional>
#include <thread>
#include <utility>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

class CaseClaimTest : public testing::Test {
 protected:
  std::optional<CaseClaim> claimed(int process = 1) const {
    return CaseClaim::of(lock_, {"node3", process, "", 0.0, false}, true);
  }
  bool is_left() const { return std::filesystem::exists(lock_); }

  test::Folder folder_;
  const std::filesystem::path lock_ = folder_.path / "a.lock";
};

TEST_F(CaseClaimTest, OneHasItAndSaysSo) {
  const auto one = claimed(7);
  ASSERT_TRUE(one);
  EXPECT_FALSE(one->left_by());
  EXPECT_FALSE(claimed(8));
  ASSERT_TRUE(holder_in(lock_));
  EXPECT_EQ(process_name(*holder_in(lock_)), "process 7 on node3");
}

TEST_F(CaseClaimTest, LeavesNoFile) {
  { const auto one = claimed(); }
  EXPECT_FALSE(is_left());
  EXPECT_FALSE(holder_in(lock_));
  EXPECT_TRUE(claimed());
}

TEST_F(CaseClaimTest, CanBeMoved) {
  auto one = claimed();
  {
    const CaseClaim moved = *std::move(one);
    one.reset();
    EXPECT_FALSE(claimed());
  }
  EXPECT_TRUE(claimed());
}

TEST_F(CaseClaimTest, ComesInTurn) {
  auto one = claimed();
  std::atomic<bool> is_given_up{false};
  const std::jthread giver([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    is_given_up = true;
    one.reset();
  });
  const CaseClaim next = CaseClaim::in_turn(lock_);
  EXPECT_TRUE(is_given_up);
}

TEST_F(CaseClaimTest, TellsWhoDiedWithIt) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    const auto claim = claimed(9);
    [[maybe_unused]] const auto written = write(ends[1], "x", 1);
    for (;;) pause();
  }
  char got = 0;
  ASSERT_EQ(read(ends[0], &got, 1), 1);
  EXPECT_FALSE(claimed()) << "it lives";
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(ends[0]);
  close(ends[1]);
  EXPECT_TRUE(is_left());
  {
    const auto next = claimed(10);
    ASSERT_TRUE(next && next->left_by());
    EXPECT_EQ(next->left_by()->process, 9);
    EXPECT_EQ(holder_in(lock_)->process, 10);
  }
  EXPECT_FALSE(is_left());
}

TEST_F(CaseClaimTest, SaysWhichFolderCannotBeUsed) {
  try {
    CaseClaim::of(folder_.path / "none/a.lock", {}, false);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("none/a.lock': No such file"));
  }
}

TEST_F(CaseClaimTest, AFileOfAnotherKindNamesNobody) {
  for (const char* text : {"", "no json", "[1]", R"({"machine": 1, "process": "x"})"}) {
    write_text(lock_, text);
    const auto holder = holder_in(lock_);
    EXPECT_TRUE(!holder || holder->process == 0) << text;
  }
}

}  // namespace
}  // namespace hackle
