// SPDX-License-Identifier: MIT
#include "base/error.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Error, SaysWhatAndWhatToDo) {
  const Error error(ErrorKind::files, "cannot write 'x'", "choose another folder");
  EXPECT_STREQ(error.what(), "cannot write 'x' (choose another folder)");
  EXPECT_EQ(error.kind(), ErrorKind::files);
}

TEST(Problems, AreThrownTogetherInOrder) {
  Problems problems;
  problems.add("one");
  problems.add("two", "mend it");
  try {
    problems.throw_if_any(ErrorKind::usage);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "one\ntwo (mend it)");
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_EQ(error.problems().size(), 2U);
  }
}

TEST(Problems, NoneThrowNothing) {
  const Problems problems;
  EXPECT_TRUE(problems.empty());
  EXPECT_NO_THROW(problems.throw_if_any());
}

TEST(ErrorKind, IsTheExitCode) {
  EXPECT_EQ(static_cast<int>(ErrorKind::run_failed), 1);
  EXPECT_EQ(static_cast<int>(ErrorKind::usage), 2);
  EXPECT_EQ(static_cast<int>(ErrorKind::script), 3);
  EXPECT_EQ(static_cast<int>(ErrorKind::refused), 4);
  EXPECT_EQ(static_cast<int>(ErrorKind::files), 5);
  EXPECT_EQ(static_cast<int>(ErrorKind::interrupted), 130);
}

}  // namespace
}  // namespace hackle
