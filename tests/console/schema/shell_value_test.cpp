// SPDX-License-Identifier: MIT
#include "console/schema/shell_value.hpp"

#include <gmock/gmock.h>

namespace hackle {
namespace {

TEST(ShellValue, ANumberMayHaveItsUnitBehindIt) {
  EXPECT_EQ(shell_expression("24MPa"), "24*MPa");
  EXPECT_EQ(shell_expression("0.5 mm"), "0.5*mm");
  EXPECT_EQ(shell_expression("-1.5e3us"), "-1.5e3*us");
  EXPECT_EQ(shell_expression(".5mm"), ".5*mm");
  EXPECT_EQ(shell_expression("3"), "3");
  EXPECT_EQ(shell_expression("1e3"), "1e3");
}

TEST(ShellValue, RangesAndListsNeedNoBraces) {
  EXPECT_EQ(shell_expression("0:12MPa"), "{0*MPa, 12*MPa}");
  EXPECT_EQ(shell_expression("-3kPa:12MPa"), "{-3*kPa, 12*MPa}");
  EXPECT_EQ(shell_expression("10us,20us"), "{10*us, 20*us}");
  EXPECT_EQ(shell_expression("10,20,30us"), "{10*us, 20*us, 30*us}");
  EXPECT_EQ(shell_expression("1,2"), "{1, 2}");
}

TEST(ShellValue, EverythingElseStaysAsItIs) {
  for (const char* text : {"", "MPa", "24*MPa", "24furlongs", "{0,12*MPa}", "0:", ":1", "1,,2", "x",
                           "0x10", "1e", "2*(10 + 2)*MPa", "true", "1,x", "--", "."})
    EXPECT_EQ(shell_expression(text), text);
}

TEST(ShellValue, KnowsTheDimensionOfAProduct) {
  EXPECT_EQ(dimension_name(*dimension_of("12*MPa")), "stress");
  EXPECT_EQ(dimension_of("3*N/mm/mm"), dimension_of("kPa"));
  EXPECT_EQ(dimension_of("2*J/m"), dimension_of("7*N"));
  EXPECT_EQ(dimension_name(*dimension_of("30*deg")), "angle");
  EXPECT_EQ(dimension_name(*dimension_of("5*mm/us")), "m s-1");
  EXPECT_EQ(dimension_of("-3"), no_dimension);
  EXPECT_EQ(dimension_of("mm/m"), no_dimension);
  for (const char* text : {"", "x", "2*x", "mm + 1", "math.pi", "(2*mm)", "2 mm", "mm*", "'mm'"})
    EXPECT_FALSE(dimension_of(text)) << text;
}

TEST(ShellValue, FindsTheDefaultOfAnOption) {
  const char* script =
      "-- options { a = 1 }\nlocal o = options { load = 12*MPa, at = { 1, 2 };\n"
      "f = g(1, 2), name = 'load = 3' }\noptions { load = 7 }";
  EXPECT_EQ(option_expression(script, "load"), "12*MPa");
  EXPECT_EQ(option_expression(script, "f"), "g(1, 2)");
  EXPECT_EQ(option_expression(script, "name"), "'load = 3'");
  EXPECT_EQ(option_expression(script, "b"), "");
  EXPECT_EQ(option_expression("", "b"), "");
  EXPECT_EQ(option_expression("options {", "b"), "");
  EXPECT_EQ(option_expression("options { b =", "b"), "");
}

}  // namespace
}  // namespace hackle
