// SPDX-License-Identifier: MIT
#include "output/summary.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hackle {
namespace {

TEST(Summary, HasTheKeysOfSchemaOneInOrder) {
  Summary summary;
  summary.nodes = 100;
  summary.steps = 30;
  summary.wall.solve = 2.0;
  summary.energy.external = 5.0;
  summary.energy.kinetic = 2.0;
  summary.files = {"a.mp4"};
  const auto json = to_json(summary);
  const char* keys[] = {
      "schema",         "script",     "nodes",          "bonds",   "steps",  "time_s",
      "dt_s",           "dt_limit_s", "precision",      "threads", "wall_s", "node_steps_per_s",
      "energy_J_per_m", "damage",     "peak_rss_bytes", "hash",    "files"};
  std::size_t at = 0;
  for (const auto& item : json.items()) EXPECT_EQ(item.key(), keys[at++]);
  EXPECT_EQ(at, std::size(keys));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["node_steps_per_s"], 1500.0);
  EXPECT_EQ(json["energy_J_per_m"]["residual"], 3.0);
  EXPECT_EQ(json["files"][0], "a.mp4");
  for (const char* stage : {"setup", "solve", "render", "encode", "store", "total"})
    EXPECT_TRUE(json["wall_s"].contains(stage)) << stage;
}

TEST(Summary, BeforeTheFirstStepTheRateIsZeroNotNaN) {
  EXPECT_EQ(Summary{}.node_steps_per_second(), 0.0);
}

}  // namespace
}  // namespace hackle
