// SPDX-License-Identifier: MIT
#include "console/prompt/kept_locals.hpp"

#include <gmock/gmock.h>

namespace hackle {
namespace {

TEST(KeptLocals, BecomeGlobals) {
  EXPECT_EQ(with_locals_kept("local a = 1"), "a = 1");
  EXPECT_EQ(with_locals_kept("local a, b = f()"), "a, b = f()");
  EXPECT_EQ(with_locals_kept("local a, b"), "a, b = nil");
  EXPECT_EQ(with_locals_kept("local function f() end"), "function f() end");
  EXPECT_EQ(with_locals_kept("x = 1 local y = x\nlocal z"), "x = 1 y = x\nz = nil");
}

TEST(KeptLocals, ConstantsBecomeVariables) {
  EXPECT_EQ(with_locals_kept("local a <const> = 1"), "a  = 1");
  EXPECT_EQ(with_locals_kept("local a <const>, b"), "a , b = nil");
}

TEST(KeptLocals, AreLeftWhereTheyEndWithABlockOrAreClosed) {
  for (const char* text :
       {"do local a = 1 end", "for i = 1, 2 do local a = i end", "function f() local a end",
        "if x then local a = 1 elseif y then local b = 2 else local c = 3 end",
        "repeat local a = f() until a", "local a <close> = f()", "while true do local a end",
        "-- local a\nx = 'local b'", "t = { f = function() local a end }"})
    EXPECT_EQ(with_locals_kept(text), text);
}

TEST(KeptLocals, OutsideABlockAgain) {
  EXPECT_EQ(with_locals_kept("if x then local a = 1 end local b = 2"),
            "if x then local a = 1 end b = 2");
  EXPECT_EQ(with_locals_kept("repeat local a = f() until a\nlocal b = 2"),
            "repeat local a = f() until a\nb = 2");
}

TEST(KeptLocals, WhatIsNotYetAStatementStays) {
  for (const char* text :
       {"local", "local 1", "local a,", "local a <", "local 'a'", "", "end local"})
    EXPECT_EQ(with_locals_kept(text), text);
}

TEST(KeptLocals, LinesKeepTheirNumbers) {
  EXPECT_EQ(with_locals_kept("local\n\na = 1"), "\n\na = 1");
}

}  // namespace
}  // namespace hackle
