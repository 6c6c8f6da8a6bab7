// SPDX-License-Identifier: MIT
#include "lattice/family.hpp"

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "lattice/node_layout.hpp"

namespace hackle {
namespace {

TEST(Family, HasTheKnownNumberOfBonds) {
  // Lattice points with 0 < a^2 + b^2 <= m^2 (src/lattice/README.md 1.3).
  const std::pair<double, int> known[] = {{2, 12}, {3, 28},  {3.015, 28}, {4, 48},
                                          {5, 80}, {6, 112}, {8, 196}};
  for (const auto& [m, bonds] : known)
    EXPECT_EQ(Family(m, Quadrature::full).bonds(), bonds) << "m = " << m;
}

TEST(Family, AHorizonThatIsAWholeMultipleIncludesTheTieWhateverTheRounding) {
  EXPECT_EQ(Family(2e-3 / 0.5e-3, Quadrature::full).bonds(), 48);
  EXPECT_EQ(Family(0.3 / 0.1, Quadrature::full).bonds(), 28);  // 2.9999999999999996
}

TEST(Family, KeepsEveryBondAtItsLowerOrLeftEnd) {
  const Family family(5.0, Quadrature::full);
  std::set<std::pair<int, int>> offsets;
  std::set<int> bits;
  family.for_each_bond([&](int a, int b, const Vec2& xi, double, int bit) {
    EXPECT_TRUE(offsets.insert({a, b}).second);
    EXPECT_TRUE(bits.insert(bit).second);
    EXPECT_LE(a * a + b * b, 25);
    EXPECT_TRUE(b > 0 || (b == 0 && a > 0));
    EXPECT_EQ(xi, Vec2(a, b));
  });
  EXPECT_EQ(static_cast<int>(offsets.size()), family.kept());
  for (const auto& [a, b] : offsets) EXPECT_TRUE(b == 0 || offsets.contains({-a, b}));
}

TEST(Family, TheTwoKeptImagesOfAnOffsetLieInOneWord) {
  for (const double m : {2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 11.5, 16.0}) {
    const Family family(m, Quadrature::full);
    for (const Images& image : family.images()) {
      EXPECT_EQ(image.first_bit / 32, (image.first_bit + image.kept() - 1) / 32) << m;
      EXPECT_LT((image.first_bit + image.kept() - 1) / 32, family.words());
    }
  }
}

TEST(Family, ListsRowsFromFarToNear) {
  const Family family(6.0, Quadrature::full);
  const auto& images = family.images();
  for (std::size_t k = 1; k < images.size(); ++k) EXPECT_LE(images[k].b, images[k - 1].b);
}

TEST(Family, ExactAreasFillTheCircle) {
  // The cells cover the plane, so their parts add up to the circle, minus the node's own cell.
  for (const double m : {2.0, 2.5, 3.0, 4.0, 4.7, 6.0, 8.0, 12.3, 15.5}) {
    const Family family(m, Quadrature::area);
    double sum = 0.0;
    family.for_each_bond([&](int, int, const Vec2&, double weight, int) { sum += 2.0 * weight; });
    EXPECT_NEAR(sum, std::numbers::pi * m * m - 1.0, 1e-11 * m * m) << m;
  }
}

TEST(Family, ExactAreasReachTheNeighboursOfTheTable) {
  // src/lattice/README.md 1.3.
  EXPECT_EQ(Family(4.0, Quadrature::area).bonds(), 68);
  EXPECT_EQ(Family(6.0, Quadrature::area).bonds(), 136);
  EXPECT_EQ(Family(8.0, Quadrature::area).bonds(), 240);
}

TEST(Family, CentroidsLieInTheirCellsAndOnlyRimCellsMoveThem) {
  const Family family(4.3, Quadrature::centroid);
  family.for_each_bond([](int a, int b, const Vec2& xi, double weight, int) {
    EXPECT_LE((xi - Vec2(a, b)).lpNorm<Eigen::Infinity>(), 0.5);
    EXPECT_LE(xi.norm(), 4.3);
    if (weight == 1.0) {
      EXPECT_LE((xi - Vec2(a, b)).norm(), 1e-14);
    }
    if (a == 0) {
      EXPECT_EQ(xi.x(), 0.0);
    }
    if (b == 0) {
      EXPECT_EQ(xi.y(), 0.0);
    }
  });
}

TEST(Family, ExactAreasLeaveOutCellsThatOnlyTouchTheHorizon) {
  EXPECT_EQ(Family(4.5, Quadrature::area).reach(), 4);
  EXPECT_EQ(Family(2.25e-3 / 0.5e-3 + 1e-14, Quadrature::area).reach(), 4);
  EXPECT_EQ(Family(4.51, Quadrature::area).reach(), 5);
  // A corner: (3.5, 3.5) is where the cell (4, 4) begins.
  const double corner = 3.5 * std::numbers::sqrt2;
  EXPECT_EQ(Family(corner, Quadrature::area).bonds() + 4,
            Family(corner + 1e-3, Quadrature::area).bonds());
}

TEST(Family, EveryChoiceReachesNoFurtherThanAGroupOfColumnsAndHasWeights) {
  for (double m = min_m; m <= max_m; m += 0.125)
    for (const auto quadrature :
         {Quadrature::full, Quadrature::ramp, Quadrature::area, Quadrature::centroid})
      for (const auto micromodulus : {Micromodulus::constant, Micromodulus::conical}) {
        const Family family(m, quadrature, micromodulus);
        EXPECT_LE(family.reach(), NodeLayout::group) << m;
        for (const Images& image : family.images()) {
          EXPECT_GT(image.weight, 1e-12) << m;
          EXPECT_LE(image.weight, 1.0) << m;
          EXPECT_LE(image.first_bit / 32, family.words() - 1);
        }
      }
}

TEST(Family, ABondAtTheHorizonHasNoConeWhateverTheRounding) {
  for (const double m : {std::sqrt(5.0), std::sqrt(10.0), std::sqrt(41.0), 5.0}) {
    const Family family(m, Quadrature::full, Micromodulus::conical);
    for (const Images& image : family.images()) EXPECT_LT(image.length(), m - 1e-3);
  }
}

TEST(Family, AConicalMicromodulusEndsAtTheHorizon) {
  const Family family(4.0, Quadrature::full, Micromodulus::conical);
  EXPECT_EQ(family.reach(), 3);  // (4, 0) has no weight
  for (const Images& image : family.images())
    EXPECT_DOUBLE_EQ(image.weight, 1.0 - image.length() / 4.0);
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
