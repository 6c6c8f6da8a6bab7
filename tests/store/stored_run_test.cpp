// SPDX-License-Identifier: MIT
// Runs in files, as they are told apart, described and compared.
#include "store/stored_run.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "store/checkpoint.hpp"
#include "store/run_difference.hpp"
#include "store/run_facts.hpp"
#include "store/run_file.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class StoredRuns : public testing::Test {
 protected:
  Simulation simulation(double stress = 12e6) const {
    return {test::edge_crack(stress), test::numerics(2e-3, 6e-3), {1}};
  }
  // Records at 0, 1, ... us.
  fs::path run_file(const char* name, double stress = 12e6, int last = 3, bool finished = true) {
    Simulation now = simulation(stress);
    RunFile file(folder_.path / name, now, {"a.lua", "-- text"});
    file.add(now);
    for (int k = 1; k <= last; ++k) {
      now.run(1e-6);
      file.add(now);
    }
    if (finished) file.finish();
    return folder_.path / name;
  }
  fs::path checkpoint(const char* name, double time, double stress = 12e6) {
    Simulation now = simulation(stress);
    now.run(time);
    write_checkpoint(folder_.path / name, image_of(now, {"b.lua", ""}));
    return folder_.path / name;
  }
  static RunDifference compared(const fs::path& left, const fs::path& right) {
    StoredRun one(left), other(right);
    return difference(one, other);
  }

  const test::Folder folder_;
};

TEST_F(StoredRuns, SayWhatTheyAre) {
  const RunFacts facts = facts_of_run(run_file("a.h5"));
  EXPECT_TRUE(facts.is_complete);
  EXPECT_EQ(facts.records, 4);
  EXPECT_EQ(facts.times.size(), 4U);
  EXPECT_EQ(facts.origin.script_name, "a.lua");
  std::uint64_t bytes = 0;
  for (const StoredField& field : facts.fields) bytes += field.bytes;
  EXPECT_LT(bytes, fs::file_size(folder_.path / "a.h5"));
  const auto moved =
      std::ranges::find(facts.fields, std::string("displacement"), &StoredField::name);
  ASSERT_NE(moved, facts.fields.end());
  // Two components of the three records that move, and less than that by packing.
  EXPECT_LE(moved->bytes, 3U * 1000U * 2U * sizeof(float) + 4096U);
  EXPECT_GT(moved->bytes, 0U);
  EXPECT_EQ(std::ranges::count(facts.fields, std::string("damage"), &StoredField::name), 1);
}

TEST_F(StoredRuns, OneThatWasCutOffSaysSo) {
  EXPECT_FALSE(facts_of_run(run_file("a.h5", 12e6, 2, false)).is_complete);
}

TEST_F(StoredRuns, AreShownStateByState) {
  StoredRun run(run_file("a.h5"));
  EXPECT_EQ(run.kind(), StoredKind::run);
  ASSERT_EQ(run.times().size(), 4U);
  run.show(2);
  EXPECT_NEAR(run.view().time(), 2e-6, 1e-12);
  EXPECT_FALSE(run.is_exact());
  StoredRun saved(checkpoint("a.ckpt", 3e-6));
  EXPECT_EQ(saved.kind(), StoredKind::checkpoint);
  EXPECT_EQ(saved.times().size(), 1U);
  EXPECT_TRUE(saved.is_exact());
  EXPECT_EQ(saved.last_step(), run.last_step());
}

TEST_F(StoredRuns, OfOneSceneAreEqual) {
  const fs::path run = run_file("a.h5");
  EXPECT_TRUE(compared(run, run_file("b.h5")).is_none());
  // All times of the checkpoint are among those of the run.
  const fs::path saved = checkpoint("a.ckpt", 3e-6);
  EXPECT_TRUE(compared(saved, run).is_none());
  EXPECT_TRUE(compared(run, saved).is_none());
  EXPECT_TRUE(compared(saved, checkpoint("b.ckpt", 3e-6)).is_none());
}

TEST_F(StoredRuns, OfOtherLoadsDifferFromTheFirstMotionOn) {
  const RunDifference found = compared(run_file("a.h5"), run_file("b.h5", 14e6));
  ASSERT_EQ(found.inputs.size(), 2U);
  EXPECT_EQ(found.inputs[0].path, "tractions[1].stress");
  EXPECT_TRUE(found.same_grid);
  EXPECT_EQ(found.common.size(), 4U);
  ASSERT_TRUE(found.first_time().has_value());
  EXPECT_NEAR(*found.first_time(), 1e-6, 1e-12);  // at the start nothing moves
  ASSERT_FALSE(found.fields.empty());
  const FieldCourse& moved = found.fields[0];
  EXPECT_EQ(moved.largest.name, "displacement");
  EXPECT_NEAR(moved.at, 3e-6, 1e-12);
  // Before anything breaks displacements grow with the load, to 2 parts in 12 of the larger.
  StoredRun run(folder_.path / "a.h5");
  run.show(3);
  double largest = 0.0;
  const Grid& grid = run.view().lattice().grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      largest = std::max(largest, run.view().displacement(i, j).norm());
  EXPECT_NEAR(moved.largest.max, largest * 2.0 / 12.0, 1e-3 * largest);
}

TEST_F(StoredRuns, WithMoreRecordsDiffer) {
  const RunDifference found = compared(run_file("a.h5"), run_file("b.h5", 12e6, 5));
  EXPECT_TRUE(found.fields.empty());
  EXPECT_EQ(found.only_in_one, 0U);
  EXPECT_EQ(found.only_in_other, 2U);
  EXPECT_FALSE(found.is_none());
}

TEST_F(StoredRuns, AtNoCommonTimeDiffer) {
  EXPECT_FALSE(compared(checkpoint("a.ckpt", 1e-6), checkpoint("b.ckpt", 2e-6)).is_none());
}

TEST_F(StoredRuns, OnOtherLatticesAreComparedByTheirInputs) {
  Simulation finer(test::edge_crack(12e6), test::numerics(1e-3, 4e-3), {1});
  write_checkpoint(folder_.path / "fine.ckpt", image_of(finer, {}));
  const RunDifference found = compared(checkpoint("a.ckpt", 0.0), folder_.path / "fine.ckpt");
  EXPECT_FALSE(found.same_grid);
  EXPECT_TRUE(found.fields.empty());
  EXPECT_EQ(found.inputs.front().path, "spacing");
}

// Functions are not in the file, but the state is.
TEST_F(StoredRuns, ACheckpointOfFunctionsIsShownWithoutThem) {
  Plate plate = test::edge_crack(12e6);
  plate.loads.tractions[0].amplitude = Amplitude([](double) { return 1.0; }, "one");
  Simulation now(plate, test::numerics(2e-3, 6e-3), {1});
  now.run(2e-6);
  write_checkpoint(folder_.path / "a.ckpt", image_of(now, {}));
  StoredRun saved(folder_.path / "a.ckpt");
  EXPECT_FALSE(saved.velocity_is_of_its_time());
  // Of its last step, not of the time between two that was asked for.
  EXPECT_EQ(saved.view().displacement(3, 2), now.view().at_step().displacement(3, 2));
  EXPECT_TRUE(compared(folder_.path / "a.ckpt", folder_.path / "a.ckpt").is_none());
}

TEST_F(StoredRuns, OtherFilesAreRefused) {
  write_text(folder_.path / "a.txt", "text");
  write_text(folder_.path / "a.h5", "\x89HDF\r\n\x1a\n and then nothing");
  write_text(folder_.path / "a.ckpt", "Hackle checkpoint 1\n12\n");
  for (const char* name : {"a.txt", "a.h5", "a.ckpt", "none", "."}) {
    try {
      StoredRun run(folder_.path / name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::files) << name;
      EXPECT_THAT(error.what(), HasSubstr(name));
    }
  }
}

}  // namespace
}  // namespace hackle
