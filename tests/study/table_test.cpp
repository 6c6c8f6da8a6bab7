// SPDX-License-Identifier: MIT
#include "study/table.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(StudyTable, AlignsNumbersToTheRight) {
  const Table table{{"a", "bb", "name"}, {{"1.5", "2", "one"}, {"10", "300", "µ"}}};
  EXPECT_EQ(aligned(table),
            "a     bb  name\n"
            "1.5    2  one\n"
            "10   300  µ\n");
}

TEST(StudyTable, QuotesForCsv) {
  const Table table{{"a,b", "c"}, {{"say \"so\"", "x\ny"}}};
  EXPECT_EQ(csv_of(table), "\"a,b\",c\n\"say \"\"so\"\"\",\"x\ny\"\n");
}

}  // namespace
}  // namespace hackle
