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

TEST(Material, AlphaIsAShare) {
  Material material = test::duran50();
  for (const double good : {0.0, 0.02, 0.25}) {
    material.alpha = good;
    EXPECT_EQ(problems_of(material), "");
  }
  for (const double bad : {-0.1, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    material.alpha = bad;
    EXPECT_THAT(problems_of(material),
                testing::HasSubstr(bad == bad ? "at least 0 and below 1" : "alpha is nan"));
  }
}

TEST(Material, DescriptionCarriesUnits) {
  EXPECT_EQ(describe(test::duran50()), "Duran 50 glass (E 65 GPa, rho 2235 kg/m3, G0 204 J/m2)");
  Material tough = test::duran50();
  tough.alpha = 0.25;
  EXPECT_EQ(describe(tough), "Duran 50 glass (E 65 GPa, rho 2235 kg/m3, G0 204 J/m2, alpha 0.25)");
}

TEST(Material, ThermalExpansionIsNotNegative) {
  Material material = test::duran50();
  material.alphaT = 3.3e-6;
  EXPECT_EQ(problems_of(material), "");
  for (const double bad :
       {-1e-6, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    material.alphaT = bad;
    EXPECT_THAT(problems_of(material), testing::HasSubstr("alphaT is"));
  }
}

TEST(Material, EitherG0OrS0IsGiven) {
  Material material = test::duran50();
  material.s0 = 1e-3;
  EXPECT_THAT(problems_of(material), testing::HasSubstr("both G0 and s0 are given"));
  material.G0 = 0.0;
  EXPECT_EQ(problems_of(material), "");
  for (const double bad : {-1e-3, 1.0, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
    material.s0 = bad;
    EXPECT_THAT(problems_of(material), testing::HasSubstr("material: s0 is")) << bad;
  }
}

TEST(Material, DescriptionSaysWhatIsSpecial) {
  Material material = test::duran50();
  material.G0 = 0.0;
  material.s0 = 1e-3;
  material.alphaT = 7.5e-6;
  EXPECT_EQ(describe(material),
            "Duran 50 glass (E 65 GPa, rho 2235 kg/m3, s0 0.001, alphaT 7.5e-06 1/K)");
}

}  // namespace
}  // namespace hackle
