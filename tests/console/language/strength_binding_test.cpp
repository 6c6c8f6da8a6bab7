// SPDX-License-Identifier: MIT
#include "console/language/strength_binding.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

std::string after_plate(const std::string& call) {
  return test::message_of(test::plate_p + call);
}

TEST(StrengthBinding, TakesBothDistributionsAndSaysSo) {
  EXPECT_EQ(
      after_plate("p:strength { modulus = 10, correlation = 2*mm, seed = 7 }\n"
                  "assert(tostring(p):find('strength scattered (Weibull modulus 10, correlated "
                  "over 2 mm, seed 7)', 1, true), tostring(p))\n"
                  "p:strength { distribution = 'normal', deviation = 0.1 }\n"
                  "assert(tostring(p):find('(deviation 0.1, seed 1)', 1, true), tostring(p))\n"
                  "simulate(p, { spacing = 2*mm })"),
      "");
}

TEST(StrengthBinding, TheSpreadMustFitTheDistribution) {
  EXPECT_THAT(after_plate("p:strength {}"), HasSubstr("a weibull distribution takes modulus"));
  EXPECT_THAT(after_plate("p:strength { deviation = 0.1 }"),
              HasSubstr("takes modulus and no deviation"));
  EXPECT_THAT(after_plate("p:strength { distribution = 'normal', modulus = 10 }"),
              HasSubstr("a normal distribution takes deviation and no modulus"));
  EXPECT_THAT(after_plate("p:strength { modulus = 10, deviation = 0.1 }"),
              HasSubstr("no deviation"));
}

TEST(StrengthBinding, RefusesWhatMakesNoSense) {
  for (const char* options :
       {"modulus = 0.5", "modulus = 1001", "modulus = 0/0", "modulus = 1/0", "modulus = 'a'",
        "distribution = 'normal', deviation = 0", "distribution = 'normal', deviation = 0.31",
        "distribution = 'normal', deviation = -1/0", "modulus = 5, correlation = -1",
        "modulus = 5, correlation = 1/0", "modulus = 5, correlation = {}",
        "modulus = 5, seed = 1.5", "modulus = 5, seed = '1'", "modulus = 5, distribution = 'gauss'",
        "modulus = 5, sed = 1"})
    EXPECT_THAT(after_plate(std::string("p:strength { ") + options + " }"), HasSubstr("strength: "))
        << options;
  EXPECT_THAT(after_plate("p:strength(5)"), HasSubstr("strength: "));
  EXPECT_THAT(after_plate("p:strength()"), HasSubstr("strength: "));
}

}  // namespace
}  // namespace hackle
