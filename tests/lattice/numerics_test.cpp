// SPDX-License-Identifier: MIT
#include "lattice/numerics.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t plenty = std::uint64_t{1} << 40;

std::string problems_of(const Numerics& numerics, std::uint64_t memory = plenty) {
  Problems problems;
  check(test::edge_crack(12e6), numerics, memory, problems);
  try {
    problems.throw_if_any();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "";
}

TEST(Numerics, TheUsualChoicesAreAccepted) {
  EXPECT_EQ(problems_of(test::numerics()), "");
  EXPECT_EQ(problems_of(test::numerics(0.5e-3, 1e-3)), "");  // exactly two spacings
}

TEST(Numerics, SpacingMustBePositiveAndFit) {
  for (const double bad : {0.0, -1e-3, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THAT(problems_of(test::numerics(bad)), HasSubstr("it must be above 0 m"));
  EXPECT_THAT(problems_of(test::numerics(0.05, 0.2)), HasSubstr("larger than the plate"));
}

TEST(Numerics, TheHorizonMustSpanTwoToSixteenSpacings) {
  EXPECT_THAT(problems_of(test::numerics(0.5e-3, 0.9e-3)), HasSubstr("under 2 spacings"));
  EXPECT_THAT(problems_of(test::numerics(0.5e-3, 9e-3)), HasSubstr("over 16 spacings"));
}

TEST(Numerics, TooManyNodesSayHowMuchIsNeededAndHowMuchThereIs) {
  const std::string text = problems_of(test::numerics(1e-6, 4e-6), std::uint64_t{8} << 30);
  EXPECT_THAT(text, HasSubstr("4e+09 nodes need"));
  EXPECT_THAT(text, HasSubstr("8.59 GB are free"));
  EXPECT_THAT(text, HasSubstr("a spacing of"));
}

TEST(Numerics, EvenAnAbsurdSpacingIsRefusedForItsMemory) {
  EXPECT_THAT(problems_of(test::numerics(1e-300, 4e-300)), HasSubstr("memory"));
}

TEST(Numerics, AStepAboveTheLimitIsRefusedUnlessForced) {
  Numerics numerics = test::numerics();
  numerics.step = 240e-9;
  EXPECT_THAT(problems_of(numerics), HasSubstr("step is 240 ns, above the stability limit of 232"));
  numerics.force_step = true;
  EXPECT_EQ(problems_of(numerics), "");
}

TEST(Numerics, MemoryIsThatOfTheArrays) {
  // 48 bytes of u, v, a, 2 of born, 8 for each of lattice's, state's and the zones' bond bits.
  EXPECT_DOUBLE_EQ(memory_needed(test::edge_crack(0.0), test::numerics()), 16000.0 * 63.0);
}

}  // namespace
}  // namespace hackle
