// SPDX-License-Identifier: MIT
#include "base/interrupt.hpp"

#include <csignal>

#include <gtest/gtest.h>

namespace hackle {
namespace {

class Interrupt : public testing::Test {
 protected:
  void TearDown() override { clear_interrupt(); }
};

TEST_F(Interrupt, ASignalSetsTheFlag) {
  const InterruptHandler handler;
  EXPECT_FALSE(interrupted());
  testing::internal::CaptureStderr();
  std::raise(SIGINT);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "\nstopping after this step (again to abort)\n");
  EXPECT_TRUE(interrupted());
  clear_interrupt();
  EXPECT_FALSE(interrupted());
}

TEST_F(Interrupt, ASecondSignalEndsTheProcess) {
  const auto twice = [] {
    const InterruptHandler handler;
    std::raise(SIGINT);
    std::raise(SIGINT);
  };
  EXPECT_EXIT(twice(), testing::KilledBySignal(SIGINT), "stopping after this step");
}

TEST_F(Interrupt, TheFormerHandlerComesBack) {
  std::signal(SIGTERM, SIG_IGN);
  { const InterruptHandler handler; }
  struct sigaction now {};
  sigaction(SIGTERM, nullptr, &now);
  EXPECT_EQ(now.sa_handler, SIG_IGN);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace
}  // namespace hackle
