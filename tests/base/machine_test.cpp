// SPDX-License-Identifier: MIT
#include "base/machine.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Machine, HasMemoryAndCores) {
  EXPECT_GT(available_memory(), std::uint64_t{1} << 24);
  EXPECT_LT(available_memory(), std::uint64_t{1} << 50);
  EXPECT_GE(available_cores(), 1);
  EXPECT_FALSE(processor_name().empty());
}

TEST(Machine, PeakMemoryGrowsWithWhatIsTouched) {
  const std::uint64_t before = peak_resident_memory();
  const std::vector<char> block(std::size_t{64} << 20, 'x');
  EXPECT_GT(peak_resident_memory(), before);
  EXPECT_EQ(block.back(), 'x');
}

}  // namespace
}  // namespace hackle
