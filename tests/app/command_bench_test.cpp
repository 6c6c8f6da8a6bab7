// SPDX-License-Identifier: MIT
#include "app/command_bench.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/lammps_peer.hpp"
#include "app/program.hpp"
#include "base/error.hpp"
#include "support/skipping.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

class CommandBenchTest : public testing::Test {
 protected:
  test::Ended bench(std::vector<std::string> words) {
    words.insert(words.begin(), {"bench", "--rounds", "1", "--nodes", "1000"});
    return program_.run(words);
  }

  test::Folder folder_;
  test::Program program_{folder_};
};

TEST_F(CommandBenchTest, JsonHasARowForEveryConfiguration) {
  const auto ended = bench({"--peer", "none", "--json", "-q"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["rounds"], 1);
  EXPECT_TRUE(json["machine"]["processor"].is_string());
  EXPECT_TRUE(json["lammps"].is_null());
  ASSERT_EQ(json["rows"].size(), configurations.size());
  for (const auto& row : json["rows"]) {
    EXPECT_TRUE(row["name"].is_string());
    for (const char* key : {"nodes", "steps", "threads"}) EXPECT_GT(row[key].get<int>(), 0) << key;
    EXPECT_GT(row["bytes_per_node"].get<double>(), 32.0);
    const double speed = row["node_steps_per_second"];
    EXPECT_GT(speed, 0.0);
    EXPECT_DOUBLE_EQ(row["bond_visits_per_second"].get<double>(), 48 * speed);
    EXPECT_TRUE(row["ratio_to_lammps"].is_null());
  }
}

TEST_F(CommandBenchTest, LammpsIsMeasuredWhenItIsThere) {
  HACKLE_NEEDS(lammps_is_installed(), "lmp is not on the PATH");
  const auto ended = bench({"--peer", "lammps", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_GT(json["rows"][0]["ratio_to_lammps"].get<double>(), 0.0);
  const auto& peer = json["lammps"]["rows"][0];
  EXPECT_EQ(peer["nodes"], json["rows"][0]["nodes"]);
  EXPECT_GT(peer["node_steps_per_second"].get<double>(), 0.0);
  EXPECT_GT(peer["bytes_per_node"].get<double>(), 48.0);
}

TEST_F(CommandBenchTest, PrintsATable) {
  const auto ended = bench({"--peer", "none", "-q"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("M node-steps/s"));
  EXPECT_THAT(ended.out, HasSubstr("\nf64 "));
}

TEST_F(CommandBenchTest, RefusesWhatMakesNoSense) {
  EXPECT_EQ(bench({"--peer", "abacus"}).code, 2);
  EXPECT_EQ(bench({"--rounds", "0"}).code, 2);
}

TEST(LammpsPeer, ReadsTheLog) {
  const LammpsRun run = read_lammps_log(
      "LAMMPS (29 Sep 2021 - Update 2)\n"
      "Per MPI rank memory allocation (min/avg/max) = 64 | 64 | 64 Mbytes\n"
      "Loop time of 2.5 on 1 procs for 50 steps with 65536 atoms\n");
  EXPECT_EQ(run.version, "29 Sep 2021 - Update 2");
  EXPECT_DOUBLE_EQ(run.node_steps_per_second(), 65536 * 50 / 2.5);
  EXPECT_DOUBLE_EQ(run.bytes_per_node(), 1024.0);
  EXPECT_THROW(read_lammps_log("ERROR"), Error);
}

}  // namespace
}  // namespace hackle
