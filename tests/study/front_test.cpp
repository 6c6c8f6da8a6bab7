// SPDX-License-Identifier: MIT
#include "study/front.hpp"

#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace hackle {
namespace {

using testing::ElementsAre;

TEST(Front, HoldsWhatNothingBeats) {
  const std::vector<Candidate> all{{1, 5}, {2, 3}, {3, 4}, {4, 1}, {2, 6}};
  EXPECT_THAT(front_of(all), ElementsAre(true, true, false, true, false));
}

TEST(Front, HoldsOnlyTheFirstOfTwins) {
  const std::vector<Candidate> all{{1, 1}, {1, 1}};
  EXPECT_THAT(front_of(all), ElementsAre(true, false));
}

TEST(Front, LeavesOutWhatFailed) {
  constexpr double nothing = std::numeric_limits<double>::infinity();
  const std::vector<Candidate> all{{0.5, nothing}, {1, 1}, {0.1, std::nan("")}};
  EXPECT_THAT(front_of(all), ElementsAre(false, true, false));
}

TEST(Front, EveryOtherOneIsBeatenByOneOfTheFront) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> few(0, 12);
  std::vector<Candidate> all(200);
  for (Candidate& one : all) one = {double(few(random)), double(few(random))};
  const std::vector<bool> front = front_of(all);
  for (std::size_t k = 0; k < all.size(); ++k) {
    bool beaten = false;
    for (std::size_t l = 0; l < all.size(); ++l)
      beaten = beaten ||
               (l != k && front[l] && all[l].cost <= all[k].cost && all[l].error <= all[k].error);
    EXPECT_NE(beaten, front[k]) << k;
  }
}

}  // namespace
}  // namespace hackle
