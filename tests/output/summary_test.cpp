// SPDX-License-Identifier: MIT
#include "output/summary.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
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
  summary.paths[static_cast<int>(Path::still)] = 10;
  summary.paths[static_cast<int>(Path::careful)] = 30;
  const auto json = to_json(summary);
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  EXPECT_THAT(
      keys, testing::ElementsAre("schema", "script", "nodes", "bonds", "steps", "time_s", "dt_s",
                                 "dt_limit_s", "precision", "threads", "tile_paths", "step_shares",
                                 "kernel_features", "wall_s", "node_steps_per_s", "energy_J_per_m",
                                 "damage", "peak_rss_bytes", "hash", "files"));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["node_steps_per_s"], 1500.0);
  EXPECT_EQ(json["energy_J_per_m"]["residual"], 3.0);
  EXPECT_EQ(json["files"][0], "a.mp4");
  EXPECT_EQ(json["tile_paths"]["still"], 0.25);
  EXPECT_EQ(json["tile_paths"]["careful"], 0.75);
  for (const char* stage : {"setup", "solve", "render", "encode", "store", "total"})
    EXPECT_TRUE(json["wall_s"].contains(stage)) << stage;
}

TEST(Summary, BeforeTheFirstStepTheRateIsZeroNotNaN) {
  EXPECT_EQ(Summary{}.node_steps_per_second(), 0.0);
}

}  // namespace
}  // namespace hackle
