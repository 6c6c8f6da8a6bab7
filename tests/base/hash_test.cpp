// SPDX-License-Identifier: MIT
#include "base/hash.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hackle {
namespace {

std::string hash_of(const std::vector<double>& values) {
  Hash hash;
  hash.add(std::span(values));
  return hash.hex();
}

TEST(Hash, IsThatOfXxh3) {
  EXPECT_EQ(Hash().hex(), "2d06800538d394c2");  // published XXH3_64bits of empty input
}

TEST(Hash, TellsSingleBitsApart) {
  EXPECT_EQ(hash_of({1.0, 2.0}), hash_of({1.0, 2.0}));
  EXPECT_NE(hash_of({1.0, 2.0}), hash_of({1.0, std::nextafter(2.0, 3.0)}));
  EXPECT_NE(hash_of({0.0}), hash_of({-0.0}));
}

TEST(Hash, DoesNotDependOnHowTheBytesAreHandedOver) {
  const std::vector<double> values{1.0, 2.0, 3.0};
  Hash hash;
  hash.add(std::span(values).first(1));
  hash.add(std::span(values).subspan(1));
  EXPECT_EQ(hash.hex(), hash_of(values));
}

}  // namespace
}  // namespace hackle
