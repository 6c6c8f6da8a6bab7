// SPDX-License-Identifier: MIT
// Tests that need what not every machine has. Where HACKLE_FORBID_SKIPS is set, as in CI, which
// provides all of it, they fail instead of passing over it in silence. What a processor lacks
// nobody can provide: those tests use GTEST_SKIP itself.
#pragma once

#include <cstdlib>

#include <gtest/gtest.h>

// Ends the test, which must be a function without a value: SetUp or a body.
#define HACKLE_NEEDS(condition, reason)                                    \
  if (!(condition)) {                                                      \
    if (std::getenv("HACKLE_FORBID_SKIPS") != nullptr) FAIL() << (reason); \
    GTEST_SKIP() << (reason);                                              \
  }                                                                        \
  static_assert(true)
