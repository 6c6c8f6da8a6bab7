// SPDX-License-Identifier: MIT
#include "base/renamed.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Renamed, TellsThePresentNameOfTheSameOwner) {
  EXPECT_EQ(renamed("plate", "start"), "initial");
  EXPECT_EQ(renamed("simulation", "pieces"), "fragments");
  EXPECT_EQ(renamed("simulation", "start"), std::nullopt);  // a present name
  EXPECT_EQ(renamed("plate", "initial"), std::nullopt);
}

}  // namespace
}  // namespace hackle
