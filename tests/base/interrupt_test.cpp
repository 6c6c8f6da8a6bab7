// SPDX-License-Identifier: MIT
#include "base/interrupt.hpp"

#include <csignal>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.hpp"

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

TEST_F(Interrupt, AClosedTerminalMaySaySoTwice) {
  const auto twice = [] {
    const InterruptHandler handler;
    std::raise(SIGHUP);
    std::raise(SIGHUP);
    _exit(interrupted() && asked_to_leave() ? 7 : 0);
  };
  EXPECT_EXIT(twice(), testing::ExitedWithCode(7), "stopping after this step");
}

TEST_F(Interrupt, CtrlCDoesNotAskToLeave) {
  const auto once = [] {
    const InterruptHandler handler;
    std::raise(SIGINT);
    _exit(asked_to_leave() ? 1 : 0);
  };
  EXPECT_EXIT(once(), testing::ExitedWithCode(0), "");
}

TEST_F(Interrupt, AnIgnoredHangupStaysIgnored) {
  std::signal(SIGHUP, SIG_IGN);
  {
    const InterruptHandler handler;
    std::raise(SIGHUP);
  }
  EXPECT_FALSE(interrupted());
  std::signal(SIGHUP, SIG_DFL);
}

TEST_F(Interrupt, TheKeyboardCanBeLeftAlone) {
  std::signal(SIGINT, SIG_IGN);
  {
    const InterruptHandler handler(InterruptHandler::Keyboard::left_alone);
    std::raise(SIGINT);
  }
  EXPECT_FALSE(interrupted());
  std::signal(SIGINT, SIG_DFL);
}

TEST_F(Interrupt, ALoopWithNothingToCompleteIsLeftByAnError) {
  EXPECT_NO_THROW(throw_if_interrupted());
  request_interrupt();
  try {
    throw_if_interrupted();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
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
