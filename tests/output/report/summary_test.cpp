// SPDX-License-Identifier: MIT
#include "output/report/summary.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "output/files/record_options.hpp"
#include "output/picture/picture.hpp"
#include "output/run/run.hpp"
#include "solver/simulation.hpp"
#include "support/scenes.hpp"

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
  summary.notes = {"beware"};
  summary.paths[static_cast<int>(Path::still)] = 10;
  summary.paths[static_cast<int>(Path::careful)] = 30;
  const auto json = to_json(summary);
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  EXPECT_THAT(keys,
              testing::ElementsAre("schema", "script", "nodes", "bonds", "steps", "time_s", "dt_s",
                                   "dt_limit_s", "numerics", "material", "precision", "threads",
                                   "tile_paths", "step_shares", "kernel_features", "wall_s",
                                   "node_steps_per_s", "energy_J_per_m", "residual_share", "damage",
                                   "account", "peak_rss_bytes", "hash", "files", "notes"));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["node_steps_per_s"], 1500.0);
  EXPECT_EQ(json["energy_J_per_m"]["residual"], 3.0);
  EXPECT_EQ(json["residual_share"], 0.6);
  EXPECT_EQ(json["notes"][0], "beware");
  EXPECT_EQ(json["files"][0], "a.mp4");
  EXPECT_EQ(json["tile_paths"]["still"], 0.25);
  EXPECT_EQ(json["tile_paths"]["careful"], 0.75);
  for (const char* stage : {"setup", "solve", "render", "encode", "store", "total"})
    EXPECT_TRUE(json["wall_s"].contains(stage)) << stage;
}

TEST(Summary, HasReactionsWhereThereAreBodies) {
  Summary summary;
  summary.reactions = {{"press", "platen", 2, {1.5, 2.5}, {3.5, 4.5}, 5.5, {6.5, 7.5}}};
  const auto reactions = to_json(summary)["reactions"];
  ASSERT_EQ(reactions.size(), 1U);
  EXPECT_EQ(reactions[0].dump(),
            R"({"name":"press","body":"platen","number":2,"centre_m":[1.5,2.5],)"
            R"("force_N_per_m":[3.5,4.5],"moment_N":5.5,"moved_m":[6.5,7.5]})");
}

TEST(Summary, BeforeTheFirstStepTheRateIsZeroNotNaN) {
  EXPECT_EQ(Summary{}.node_steps_per_second(), 0.0);
}

// All values differ, so that none can be under the key of another.
TEST(Summary, HasEveryValueUnderItsKey) {
  Summary summary;
  summary.script = "a.lua";
  summary.nodes = 101;
  summary.bonds = 102;
  summary.steps = 103;
  summary.time = 104.5;
  summary.dt = 105.5;
  summary.dt_limit = 106.5;
  summary.precision = "f32";
  summary.threads = 107;
  summary.stages = {{"kernel", 0.75}, {"heat", 0.25}};
  summary.features = {"alpha", "2 materials"};
  summary.wall = {1.5, 2.5, 3.5, 4.5, 5.5, 6.5};
  summary.energy.kinetic = 11.5;
  summary.energy.strain = 12.5;
  summary.energy.broken = 13.5;
  summary.energy.damped = 14.5;
  summary.energy.released = 15.5;
  summary.energy.contact = 16.5;
  summary.energy.external = 100.0;
  summary.damage = {108, 0.5};
  summary.peak_rss = 109;
  summary.hash = "0123";
  summary.files = {"a.mp4", "b.h5"};
  for (std::size_t path = 0; path < summary.paths.size(); ++path)
    summary.paths[path] = std::int64_t{1} << path;
  const auto json = to_json(summary);
  EXPECT_EQ(json["script"], "a.lua");
  EXPECT_EQ(json["nodes"], 101);
  EXPECT_EQ(json["bonds"], 102);
  EXPECT_EQ(json["steps"], 103);
  EXPECT_EQ(json["time_s"], 104.5);
  EXPECT_EQ(json["dt_s"], 105.5);
  EXPECT_EQ(json["dt_limit_s"], 106.5);
  EXPECT_EQ(json["precision"], "f32");
  EXPECT_EQ(json["threads"], 107);
  EXPECT_EQ(json["step_shares"]["kernel"], 0.75);
  EXPECT_EQ(json["step_shares"]["heat"], 0.25);
  EXPECT_EQ(json["kernel_features"].dump(), R"(["alpha","2 materials"])");
  double wall = 1.5;
  for (const char* stage : {"setup", "solve", "render", "encode", "store", "total"}) {
    EXPECT_EQ(json["wall_s"][stage], wall) << stage;
    wall += 1.0;
  }
  EXPECT_EQ(json["node_steps_per_s"], 101.0 * 103.0 / 2.5);
  double entry = 11.5;
  for (const char* name : {"kinetic", "strain", "broken", "damped", "released", "contact"}) {
    EXPECT_EQ(json["energy_J_per_m"][name], entry) << name;
    entry += 1.0;
  }
  EXPECT_EQ(json["energy_J_per_m"]["external"], 100.0);
  EXPECT_EQ(json["energy_J_per_m"]["residual"], 100.0 - 84.0);
  EXPECT_EQ(json["damage"]["broken_bonds"], 108);
  EXPECT_EQ(json["damage"]["max"], 0.5);
  EXPECT_EQ(json["peak_rss_bytes"], 109);
  EXPECT_EQ(json["hash"], "0123");
  EXPECT_EQ(json["files"].dump(), R"(["a.mp4","b.h5"])");
  const double all = static_cast<double>((1 << summary.paths.size()) - 1);
  for (std::size_t path = 0; path < summary.paths.size(); ++path)
    EXPECT_EQ(json["tile_paths"][std::string(path_names[path])],
              static_cast<double>(1 << path) / all);
}

// The summary of a run equals the values of its simulation.
TEST(Summary, OfARunIsThatOfItsSimulation) {
  Plate plate = test::edge_crack(30e6);
  plate.contact = Contact{};
  plate.loads.damping = 1e4;
  Numerics numerics = test::numerics(1e-3, 3e-3);
  numerics.precision = Precision::f32;
  hackle::Run run(plate, numerics, {2}, Talk::quiet, {"small.lua", "-- x"});
  run.run(15e-6);
  const Summary summary = run.summary();
  const Simulation& simulation = run.simulation();
  EXPECT_EQ(summary.script, "small.lua");
  EXPECT_EQ(summary.nodes, 4000);
  EXPECT_EQ(summary.bonds, simulation.lattice().initial_bonds());
  EXPECT_LT(simulation.state().bonds.count(), summary.bonds);
  EXPECT_EQ(summary.steps, simulation.state().step);
  EXPECT_EQ(summary.time, 15e-6);  // the last step is less than a step later
  EXPECT_EQ(summary.steps, std::ceil(15e-6 / simulation.dt() - 1e-6));
  EXPECT_EQ(summary.dt, simulation.dt());
  EXPECT_EQ(summary.dt_limit, simulation.lattice().step_limit);
  EXPECT_NE(summary.dt, summary.dt_limit);
  EXPECT_EQ(summary.precision, "f32");
  EXPECT_EQ(summary.threads, 2);
  EXPECT_EQ(summary.paths, simulation.path_counts());
  const Energy ledger = energy(simulation);
  EXPECT_EQ(summary.energy.kinetic, ledger.kinetic);
  EXPECT_EQ(summary.energy.strain, ledger.strain);
  EXPECT_EQ(summary.energy.broken, ledger.broken);
  EXPECT_EQ(summary.energy.damped, ledger.damped);
  EXPECT_EQ(summary.energy.contact, ledger.contact);
  EXPECT_EQ(summary.energy.external, ledger.external);
  EXPECT_EQ(summary.damage.broken_bonds, count_damage(simulation).broken_bonds);
  EXPECT_EQ(summary.damage.max, count_damage(simulation).max);
  EXPECT_GT(summary.damage.broken_bonds, 0);
  EXPECT_EQ(summary.hash, simulation.state().hash());
  EXPECT_TRUE(summary.files.empty());
  EXPECT_EQ(summary.wall.solve, simulation.solve_seconds());
  EXPECT_GE(summary.wall.total, summary.wall.setup + summary.wall.solve);
}

}  // namespace
}  // namespace hackle
