// SPDX-License-Identifier: MIT
#include "console/replay/call_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/thread_ranks.hpp"

namespace hackle {
namespace {

using test::ThreadRanks;
using testing::HasSubstr;

std::string problem_of(CallWatch& watch) {
  try {
    watch.compare();
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(CallWatch, FindsNothingWhereAllRanksCallTheSame) {
  ThreadRanks(3).run([](Ranks& ranks) {
    CallWatch watch(ranks);
    watch.note("hackle", "");
    EXPECT_EQ(problem_of(watch), "");
    for (int k = 0; k < 1000; ++k) watch.note("run(1)", "one");
    EXPECT_EQ(problem_of(watch), "");
  });
}

TEST(CallWatch, NamesTheFirstCallThatDiffersOnAllRanks) {
  ThreadRanks(4).run([](Ranks& ranks) {
    CallWatch watch(ranks);
    watch.note("hackle", "");
    watch.note("energy()", "");
    watch.note(ranks.rank() == 2 ? "run(2)" : "run(1)", ranks.rank() == 2 ? "two" : "one");
    watch.note(ranks.rank() == 1 ? "hash()" : "at()", "");
    EXPECT_THAT(problem_of(watch),
                HasSubstr("at call 2 of the script: rank 0 calls run(1), rank 2 run(2)"));
  });
}

TEST(CallWatch, SeesValuesThatATextDoesNotShow) {
  ThreadRanks(2).run([](Ranks& ranks) {
    CallWatch watch(ranks);
    watch.note("hackle", "");
    watch.note("run(...)", ranks.leads() ? "{every=1}" : "{every=2}");
    EXPECT_THAT(problem_of(watch), HasSubstr("diverged at call 1"));
  });
}

TEST(CallWatch, NoticesARankThatHasCalledMore) {
  ThreadRanks(2).run([](Ranks& ranks) {
    CallWatch watch(ranks);
    watch.note("hackle", "");
    watch.note("run(1)", "");
    if (!ranks.leads()) watch.note("run(2)", "");
    EXPECT_THAT(problem_of(watch), HasSubstr("at call 2 of the script: rank 0 calls nothing more, "
                                             "rank 1 run(2)"));
  });
}

}  // namespace
}  // namespace hackle
