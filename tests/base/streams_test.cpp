// SPDX-License-Identifier: MIT
#include "base/streams.hpp"

#include <cerrno>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "base/interrupt.hpp"

namespace hackle {
namespace {

// Each test runs in a separate process, because lost output is remembered.

TEST(Streams, NoFileTakesThePlaceOfAClosedOne) {
  const auto all_closed = [] {
    for (const int descriptor : {0, 1, 2}) close(descriptor);
    hold_standard_streams();
    _exit(open("/dev/null", O_RDONLY) > 2 ? 0 : 1);
  };
  EXPECT_EXIT(all_closed(), testing::ExitedWithCode(0), "");
  const auto one_closed = [] {
    close(1);
    hold_standard_streams();
    _exit(open("/dev/null", O_RDONLY) > 2 ? 0 : 1);
  };
  EXPECT_EXIT(one_closed(), testing::ExitedWithCode(0), "");
}

TEST(Streams, WhatIsPrintedIntoNothingIsKnownToBeLost) {
  const auto closed = [] {
    close(1);
    hold_standard_streams();
    print_out("{}", 1);
    say("{}", lost_output().value_or("nothing"));
    _exit(0);
  };
  EXPECT_EXIT(closed(), testing::ExitedWithCode(0), "Bad file descriptor");
  const auto full = [] {
    dup2(open("/dev/full", O_WRONLY), 1);
    hold_standard_streams();
    print_out("{}", 1);
    say("{}", lost_output().value_or("nothing"));
    _exit(0);
  };
  EXPECT_EXIT(full(), testing::ExitedWithCode(0), "No space left on device");
}

TEST(Streams, NothingIsLostWhereNothingIsSaid) {
  const auto silent = [] {
    close(1);
    hold_standard_streams();
    say("{}", lost_output().value_or("nothing"));
    _exit(0);
  };
  EXPECT_EXIT(silent(), testing::ExitedWithCode(0), "nothing");
}

TEST(Streams, AReaderThatIsGoneInterrupts) {
  const auto unread = [] {
    int ends[2];
    if (pipe(ends) != 0) _exit(1);
    dup2(ends[1], 1);
    close(ends[0]);
    hold_standard_streams();
    if (interrupted()) _exit(2);
    print_out("{}", 1);
    flush(stdout);
    _exit(interrupted() && output_is_unread() ? 0 : 3);
  };
  EXPECT_EXIT(unread(), testing::ExitedWithCode(0), "");
}

TEST(Streams, AnotherPipeThatIsGoneDoesNot) {
  const auto other = [] {
    int ends[2];
    if (pipe(ends) != 0) _exit(1);
    close(ends[0]);
    hold_standard_streams();
    const bool failed = write(ends[1], "x", 1) < 0 && errno == EPIPE;
    _exit(failed && !interrupted() && !output_is_unread() ? 0 : 2);
  };
  EXPECT_EXIT(other(), testing::ExitedWithCode(0), "");
}

TEST(Streams, AFullStderrThrowsNothing) {
  const auto full = [] {
    dup2(open("/dev/full", O_WRONLY), 2);
    say("{}", 1);
    flush(stderr);
    _exit(0);
  };
  EXPECT_EXIT(full(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace hackle
