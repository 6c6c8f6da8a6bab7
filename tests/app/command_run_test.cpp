// SPDX-License-Identifier: MIT
#include "app/command_run.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hackle {
namespace {

TEST(CommandRun, OneSimulationIsTheObject) {
  Summary summary;
  summary.nodes = 5;
  const auto json = json_of({summary}, "a.lua");
  EXPECT_EQ(json.begin().key(), "schema");
  EXPECT_EQ(json["nodes"], 5);
  EXPECT_FALSE(json.contains("simulations"));
}

TEST(CommandRun, OfSeveralTheLastIsTheObjectAndAllAreListed) {
  Summary first, last;
  first.nodes = 5;
  last.nodes = 7;
  const auto json = json_of({first, last}, "a.lua");
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["nodes"], 7);
  ASSERT_EQ(json["simulations"].size(), 2u);
  EXPECT_EQ(json["simulations"][0]["nodes"], 5);
}

TEST(CommandRun, WithoutSimulationsTheListIsEmpty) {
  EXPECT_EQ(json_of({}, "a.lua").dump(), R"({"schema":1,"script":"a.lua","simulations":[]})");
}

// Settings from the command line reach the console; all values differ.
TEST(CommandRun, SettingsHaveEveryMemberOfTheRequest) {
  RunRequest request;
  request.output_folder = "somewhere";
  request.overrides = {{"a", "1"}, {"b", "2"}};
  request.execution.threads = 3;
  request.execution.instruction_set = InstructionSet::baseline;
  request.limits.trust = true;
  request.limits.lua_memory = 5;
  request.limits.output = 7.0;
  request.json = true;
  request.quiet = true;
  const ConsoleSettings settings = settings_of(request);
  EXPECT_EQ(settings.purpose, Purpose::results);
  EXPECT_EQ(settings.output_folder, "somewhere");
  EXPECT_EQ(settings.overrides, request.overrides);
  EXPECT_EQ(settings.execution.threads, 3);
  EXPECT_EQ(settings.execution.instruction_set, InstructionSet::baseline);
  EXPECT_TRUE(settings.trust);
  EXPECT_EQ(settings.lua_memory, std::size_t{5} << 20U);
  EXPECT_EQ(settings.output_limit, 7e9);
  EXPECT_TRUE(settings.print_to_stderr);
  EXPECT_FALSE(settings.show_in_terminal);
  EXPECT_EQ(settings.talk, Talk::quiet);
  request.json = request.quiet = request.limits.trust = false;
  EXPECT_FALSE(settings_of(request).print_to_stderr);
  EXPECT_FALSE(settings_of(request).trust);
  EXPECT_NE(settings_of(request).talk, Talk::quiet);
}

}  // namespace
}  // namespace hackle
