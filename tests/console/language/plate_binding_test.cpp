// SPDX-License-Identifier: MIT
#include "console/language/plate_binding.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

TEST(PlateBinding, CallsChain) {
  EXPECT_EQ(
      test::message_of(
          test::plate_p +
          "local q = p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm}, born = 'absent' }\n"
          "  :traction { edge = 'top', stress = {0, 12*MPa} }:nofail { edge = 'top', depth = 2*mm "
          "}\n"
          "assert(rawequal(p, q))\n"
          "assert(tostring(p):find('1 crack, 1 traction, 1 no-fail zone', 1, true), tostring(p))\n"
          "assert(p.width == 100*mm and p.height == 40*mm)"),
      "");
}

TEST(PlateBinding, IsInPlaneStressUnlessItSaysStrain) {
  EXPECT_EQ(
      test::message_of(
          test::plate_p +
          "assert(not tostring(p):find('strain'))\n"
          "local q = plate { width = 1, height = 1, material = 'duran50', plane = 'strain' }\n"
          "assert(tostring(q):find('plane strain', 1, true), tostring(q))"),
      "");
}

TEST(PlateBinding, AnUnknownNameGetsTheNearest) {
  EXPECT_EQ(test::message_of(test::plate_p + "p:crck { }"),
            "test.lua:2: plate has no 'crck' (did you mean 'crack'?)");
  EXPECT_THAT(test::message_of(test::plate_p + "print(p.zzzzz)"),
              HasSubstr("plate has no 'zzzzz' (help 'plate' tells"));
}

TEST(PlateBinding, AFormerNameGetsThePresentOne) {
  EXPECT_EQ(test::message_of(test::plate_p + "p:start { velocity = {1, 0} }"),
            "test.lua:2: plate has no 'start' (it is called 'initial' now)");
  EXPECT_THAT(test::message_of(test::plate_p + "simulate(p, { spacing = 1*mm }):frame { 'a.png', "
                                               "field = 'pieces' }"),
              HasSubstr("field is 'pieces' (it is called 'fragments' now)"));
}

TEST(PlateBinding, CannotBeWrittenToNorTakenApart) {
  EXPECT_THAT(test::message_of(test::plate_p + "p.width = 2"), HasSubstr("cannot be changed"));
  EXPECT_EQ(test::message_of(test::plate_p + "assert(getmetatable(p) == 'plate')"), "");
}

TEST(PlateBinding, ADotInsteadOfAColonIsExplained) {
  EXPECT_THAT(test::message_of(test::plate_p + "p.crack { from = {0, 0}, to = {1*mm, 0} }"),
              HasSubstr("crack: it is called with a colon (as in p:crack {"));
}

TEST(PlateBinding, ATextInPlaceOfOptionsIsExplained) {
  EXPECT_THAT(test::message_of(test::plate_p + "p:crack 'middle'"),
              HasSubstr("crack: expected options in braces, got the text 'middle' (as in p:crack"));
}

TEST(PlateBinding, ProblemsOfTheCallAndOfTheSceneComeTogether) {
  EXPECT_THAT(
      test::message_of(test::plate_p + "p:crack { from = {0, 0}, to = {1, 0}, bron = 'absent' }"),
      testing::AllOf(HasSubstr("did you mean 'born'?"), HasSubstr("outside the plate")));
}

TEST(PlateBinding, ARefusedThingIsNotOnThePlate) {
  EXPECT_EQ(test::message_of(test::plate_p + "pcall(p.crack, p, { from = {0, 0}, to = {1, 0} })\n"
                                             "assert(not tostring(p):find('crack'))"),
            "");
}

TEST(PlateBinding, ANoFailZoneIsAStripOrARectangle) {
  EXPECT_EQ(test::message_of(test::plate_p + "p:nofail { from = {0, 0}, to = {1*mm, 1*mm} }"), "");
  for (const char* bad : {"{ edge = 'top' }", "{ depth = 1*mm }", "{ from = {0, 0} }",
                          "{ edge = 'top', depth = 1*mm, from = {0, 0}, to = {1, 1} }"})
    EXPECT_THAT(test::message_of(test::plate_p + "p:nofail " + bad),
                HasSubstr("the area is not clear"))
        << bad;
}

}  // namespace
}  // namespace hackle
