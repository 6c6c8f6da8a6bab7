// SPDX-License-Identifier: MIT
// Skips tests whose requirements some machines lack. If HACKLE_FORBID_SKIPS is set, as in CI, where
// everything is installed, they fail instead. Features of a processor cannot be installed: tests
// that need them use GTEST_SKIP itself.
#pragma once

#include <cstdlib>

#include <gtest/gtest.h>

// Ends the test, from a function that returns void: SetUp or a test body.
#define HACKLE_NEEDS(condition, reason)                                    \
  if (!(condition)) {                                                      \
    if (std::getenv("HACKLE_FORBID_SKIPS") != nullptr) FAIL() << (reason); \
    GTEST_SKIP() << (reason);                                              \
  }                                                                        \
  static_assert(true)
