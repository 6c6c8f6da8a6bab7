// SPDX-License-Identifier: MIT
#include "app/command_line.hpp"

#include <gmock/gmock.h>

namespace hackle {
namespace {

using testing::ElementsAre;

TEST(CommandLine, AScriptAloneIsRun) {
  EXPECT_THAT(with_command({"a.lua"}), ElementsAre("run", "a.lua"));
  EXPECT_THAT(with_command({"-j", "2", "a.lua"}), ElementsAre("run", "-j", "2", "a.lua"));
}

TEST(CommandLine, ACommandStays) {
  EXPECT_THAT(with_command({"run", "a.lua"}), ElementsAre("run", "a.lua"));
  EXPECT_THAT(with_command({"info"}), ElementsAre("info"));
}

TEST(CommandLine, WhatIsNoScriptStays) {
  EXPECT_THAT(with_command({}), ElementsAre());
  EXPECT_THAT(with_command({"--version"}), ElementsAre("--version"));
  EXPECT_THAT(with_command({"rnu"}), ElementsAre("rnu"));
}

}  // namespace
}  // namespace hackle
