// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A script that ends in its first line unless the calls in the others are refused before.
std::string begun_or_refused(const std::string& calls) {
  return test::message_of("do error 'begun' end\n" + calls);
}

TEST(ConstantCalls, AreCheckedBeforeTheScriptBegins) {
  EXPECT_THAT(
      begun_or_refused("s:frame { 'a.png', field = 'damge' }"),
      AllOf(HasSubstr("test.lua:2: frame: "), HasSubstr("damage"), Not(HasSubstr("begun"))));
  EXPECT_THAT(begun_or_refused("s:movie { 'a.mp4', every = -1*us }"), HasSubstr("every"));
  EXPECT_THAT(begun_or_refused("s:record { 'a.hdf', every = 1*us }"),
              AllOf(HasSubstr("test.lua:2: record: "), HasSubstr(".h5")));
  EXPECT_THAT(begun_or_refused("s:record { 'a.h5' }"), HasSubstr("every is missing"));
  EXPECT_THAT(begun_or_refused("s:frame { 'a.png', range = { 0, 12*MPa }, 7 }"),
              HasSubstr("test.lua:2: "));
}

TEST(ConstantCalls, AllAreRefusedAtOnceEachWithItsLine) {
  EXPECT_THAT(begun_or_refused("s:frame { 'a.png', widht = 3 }\n\ns:movie {\n'b.mp4',\nfps = 0 }"),
              AllOf(HasSubstr("test.lua:2: frame: "), HasSubstr("width"),
                    HasSubstr("test.lua:4: movie: "), HasSubstr("fps")));
}

TEST(ConstantCalls, GoodOnesBegin) {
  for (const char* call :
       {"s:frame { 'a.png', field = 'stress_1', range = { 0, 12*MPa }, width = 640 }",
        "s:movie { 'a.mp4', every = 0.25*us, fps = 25 } s:record { 'a.h5', every = 1*us }",
        "r:frame { 'a.png', time = 20*us }", "r:movie { 'a.gif', field = 'damage' }"})
    EXPECT_THAT(begun_or_refused(call), HasSubstr("begun")) << call;
}

// What only the running script knows is left to it.
TEST(ConstantCalls, OthersAreLeftToTheRun) {
  for (const char* call :
       {"s:frame { name .. '.png', field = 'damge' }", "s:frame { f(), field = 'damge' }",
        "local us = -1 s:movie { 'a.mp4', every = 1*us, widht = 2 }",
        "us = 'x' s:movie { 'a.mp4', every = us, widht = 2 }",
        "s:frame { 'a.png', field = t.field, widht = 2 }", "x:frame2 { 'a.png', widht = 2 }",
        "s:frame { 'a.png', width = 1/'a', widht = 2 }", "s:frame { 'a.png', widht = 2",
        "-- s:frame { 'a.png', widht = 2 }", "s:frame { ('x'):rep(3), widht = 2 }"})
    EXPECT_THAT(begun_or_refused(call), Not(HasSubstr("widht is"))) << call;
  EXPECT_THAT(begun_or_refused("s:frame { name, widht = 2 }"), HasSubstr("begun"));
}

TEST(ConstantCalls, AScriptThatIsNoLuaIsToldSo) {
  EXPECT_THAT(test::message_of("s:frame { 'a.png', widht = 2 } )"), HasSubstr("near ')'"));
}

}  // namespace
}  // namespace hackle
