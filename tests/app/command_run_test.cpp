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

}  // namespace
}  // namespace hackle
