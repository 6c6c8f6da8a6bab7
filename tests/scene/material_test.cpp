// SPDX-License-Identifier: MIT
#include "scene/material.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "support/scenes.hpp"

namespace hackle {
namespace {

std::string problems_of(const Material& material) {
  Problems problems;
  check(material, problems);
  try {
    problems.throw_if_any();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Material, DuranIsAccepted) {
  EXPECT_EQ(problems_of(test::duran50()), "");
}

TEST(Material, EveryBadValueIsNamedAtOnce) {
  const std::string text =
      problems_of({"x", -1.0, 0.0, 0.5, std::numeric_limits<double>::quiet_NaN()});
  for (const char* part : {"E is -1", "Pa", "rho is 0", "kg/m3", "nu is 0.5", "G0 is nan", "J/m2"})
    EXPECT_THAT(text, testing::HasSubstr(part));
}

TEST(Material, DescriptionCarriesUnits) {
  EXPECT_EQ(describe(test::duran50()), "Duran 50 glass (E 65 GPa, rho 2235 kg/m3, G0 204 J/m2)");
}

}  // namespace
}  // namespace hackle
