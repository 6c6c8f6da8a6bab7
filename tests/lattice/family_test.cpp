// SPDX-License-Identifier: MIT
#include "lattice/family.hpp"

#include <cmath>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace hackle {
namespace {

TEST(Family, HasTheKnownNumberOfBonds) {
  // Lattice points with 0 < a^2 + b^2 <= m^2 (peers.md 2, physics.md 4.3).
  const std::pair<double, int> known[] = {{2, 12}, {3, 28},  {3.015, 28}, {4, 48},
                                          {5, 80}, {6, 112}, {8, 196}};
  for (const auto& [m, bonds] : known)
    EXPECT_EQ(Family(m, Quadrature::full).bonds(), bonds) << "m = " << m;
}

TEST(Family, AHorizonThatIsAWholeMultipleIncludesTheTieWhateverTheRounding) {
  EXPECT_EQ(Family(2e-3 / 0.5e-3, Quadrature::full).bonds(), 48);
  EXPECT_EQ(Family(0.3 / 0.1, Quadrature::full).bonds(), 28);  // 2.9999999999999996
}

TEST(Family, VisitsEveryOffsetOnceWithItsOppositeAndItsMirrorImages) {
  const Family family(5.0, Quadrature::full);
  std::set<std::pair<int, int>> offsets;
  std::set<int> bits;
  family.for_each_bond([&](int a, int b, double, int bit) {
    EXPECT_TRUE(offsets.insert({a, b}).second);
    EXPECT_TRUE(bits.insert(bit).second);
    EXPECT_LE(a * a + b * b, 25);
  });
  for (const auto& [a, b] : offsets) {
    EXPECT_TRUE(offsets.contains({-a, -b}));
    EXPECT_TRUE(offsets.contains({-a, b}));
    EXPECT_TRUE(offsets.contains({b, a}));
  }
  EXPECT_EQ(*bits.rbegin(), family.bonds() - 1);
}

TEST(Family, ImagesOfOneOffsetLieInOneWord) {
  const Family family(9.0, Quadrature::full);
  for (const Images& image : family.images())
    EXPECT_EQ(image.first_bit / 64, (image.first_bit + image.count() - 1) / 64);
}

TEST(Family, OppositeImagesAreListedFromBothEnds) {
  const Family family(4.0, Quadrature::full);
  for (const Images& image : family.images())
    for (int k = 0; k < image.count(); ++k) {
      EXPECT_EQ(image.column(k), -image.column(image.count() - 1 - k));
      EXPECT_EQ(image.row(k), -image.row(image.count() - 1 - k));
    }
}

TEST(Family, TheRampHalvesTheRimAndSparesTheInside) {
  const Family family(4.0, Quadrature::ramp);
  for (const Images& image : family.images()) {
    const double expected = image.length() <= 3.5 ? 1.0 : 0.5 + (4.0 - image.length());
    EXPECT_DOUBLE_EQ(image.weight, expected) << image.a << "," << image.b;
  }
}

}  // namespace
}  // namespace hackle
