// SPDX-License-Identifier: MIT
#include "output/run/run.hpp"

#include <filesystem>
#include <functional>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "output/files/movie_options.hpp"
#include "output/files/output_names.hpp"
#include "output/files/record_options.hpp"
#include "output/report/summary.hpp"
#include "output/run/rehearsal.hpp"
#include "store/run_file.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;
using testing::HasSubstr;

hackle::Run small_run() {
  return hackle::Run(test::bare_plate(40, 20), test::numerics(), {1}, Talk::quiet,
                     {"small.lua", "-- x"});
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Run, WritesNothingBeforeTheFirstStep) {
  const fs::path folder = fresh_folder() / "new";
  hackle::Run run = small_run();
  run.movie(folder / "a.mp4", {{}, 1e-6});
  run.record(folder / "a.h5", {1e-6});
  EXPECT_FALSE(fs::exists(folder));
}

TEST(Run, LeavesAMovieARecordAndAPicture) {
  const fs::path folder = fresh_folder();
  hackle::Run run = small_run();
  run.movie(folder / "a.mp4", {{"damage", 320}, 1e-6});
  run.record(folder / "a.h5", {1e-6});
  run.run(3e-6);
  run.frame(folder / "a.png", {"damage", 320});
  run.close();
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(folder)) left.push_back(entry.path().filename());
  EXPECT_THAT(left, testing::UnorderedElementsAre("a.mp4", "a.h5", "a.xdmf", "a.png"));
  EXPECT_EQ(run.summary().files.size(), 4U);
  EXPECT_GT(run.summary().wall.render, 0.0);
  EXPECT_GT(run.summary().wall.encode, 0.0);
}

TEST(Run, OutputsDoNotChangeABitOfTheResult) {
  const fs::path folder = fresh_folder();
  hackle::Run with = small_run(), without = small_run();
  with.movie(folder / "a.mp4", {{"damage", 320}, 1e-6});
  with.record(folder / "a.h5", {1e-6});
  with.run(3e-6);
  without.run(3e-6);
  with.close();
  EXPECT_EQ(with.summary().hash, without.summary().hash);
}

TEST(Run, StepsExactlyAsOften) {
  hackle::Run run = small_run();
  run.step(7);
  EXPECT_EQ(run.simulation().state().step, 7);
  run.run(0.5 * run.simulation().dt());
  run.step(2);
  EXPECT_EQ(run.simulation().state().step, 10);
}

TEST(Run, AfterAnInterruptItsFilesAreComplete) {
  const fs::path folder = fresh_folder();
  hackle::Run run = small_run();
  run.movie(folder / "a.mp4", {{"damage", 320}, 1e-6});
  request_interrupt();
  EXPECT_THROW(run.run(10e-6), Error);
  clear_interrupt();
  run.close();
  EXPECT_TRUE(fs::exists(folder / "a.mp4"));
}

TEST(Run, ClosingTwiceIsHarmless) {
  hackle::Run run = small_run();
  run.movie(fresh_folder() / "a.mp4", {{"damage", 320}, 1e-6});
  run.run(2e-6);
  run.close();
  EXPECT_NO_THROW(run.close());
}

TEST(Run, RefusesImpossibleOutputs) {
  const fs::path folder = fresh_folder();
  hackle::Run run = small_run();
  EXPECT_THAT(refusal([&] {
                run.movie(folder / "a.mp4", {{"damge"}, 1e-6});
              }),
              HasSubstr("field is 'damge' (did you mean 'damage'?)"));
  EXPECT_THAT(refusal([&] {
                run.movie(folder / "a.mp4", {{"damage", 641}, 1e-6});
              }),
              HasSubstr("width is 641 px, it must be even"));
  EXPECT_THAT(refusal([&] {
                run.movie(folder / "a.mp4", {{}, -1e-9});
              }),
              HasSubstr("every is -1e-09 s, it must be above 0 s"));
  EXPECT_THAT(refusal([&] {
                run.movie(folder / "a.mp4", {{}, 1e-6, 0.0});
              }),
              HasSubstr("fps is 0"));
  run.movie(folder / "a.mp4", {{}, 1e-6});
  EXPECT_THAT(refusal([&] { run.record(folder / "a.mp4", {1e-6}); }),
              HasSubstr("which is no run file (one of .h5, .hdf5; movie{} makes .mp4)"));
}

TEST(Run, RefusesAFolderThatIsAFile) {
  EXPECT_THAT(refusal([&] {
                small_run().movie("/dev/null/a.mp4", {{}, 1e-6});
              }),
              HasSubstr("is not a folder"));
}

TEST(OutputLimit, RefusesWhatIsEstimatedAboveIt) {
  const test::Folder folder;
  hackle::Run run = small_run();
  run.limit_output(1e6);
  run.movie(folder.path / "a.mp4", {{"damage", 320}, 1e-6});
  run.record(folder.path / "a.h5", {1e-6});
  const std::string told = refusal([&] { run.run(1.0); });
  EXPECT_THAT(told, HasSubstr("run: its files would take about"));
  EXPECT_THAT(told, HasSubstr("the limit is 1 MB"));
  EXPECT_THAT(told, HasSubstr("a.mp4' "));
  EXPECT_THAT(told, HasSubstr("a.h5' "));
  EXPECT_THAT(told, HasSubstr(" in 1 000 001 pieces"));
  EXPECT_THAT(told, HasSubstr("--output-limit"));
  EXPECT_EQ(run.simulation().state().step, 0);
  EXPECT_EQ(refusal([&] { run.run(3e-6); }), "");
  EXPECT_THAT(refusal([&] { run.run(1e300); }), HasSubstr("its files"));
}

TEST(OutputLimit, CountsWhatIsThereAlready) {
  const test::Folder folder;
  hackle::Run run = small_run();
  run.limit_output(4e5);
  run.record(folder.path / "a.h5", {1e-6});
  std::string told;
  int runs = 0;
  for (; told.empty() && runs < 100; ++runs) told = refusal([&] { run.run(1e-6); });
  EXPECT_THAT(told, HasSubstr(" in " + std::to_string(runs + 1) + " pieces"));
  EXPECT_LT(runs, 100);
}

TEST(OutputLimit, KnowsAboutHowLargeARunFileIs) {
  const test::Folder folder;
  const fs::path file = folder.path / "a.h5";
  for (const int records : {2, 40}) {
    hackle::Run run(test::edge_crack(12e6), test::numerics(), {1}, Talk::quiet, {"a.lua", ""});
    run.record(file, {20e-6 / (records - 1)});
    run.run(20e-6);
    run.close();
    const auto size =
        static_cast<double>(fs::file_size(file) + fs::file_size(folder.path / "a.xdmf"));
    const Grid& grid = run.simulation().lattice().grid;
    const double guess = run_file_bytes(standard_contents(grid), grid, records);
    EXPECT_GT(guess, 0.8 * size) << records;
    EXPECT_LT(guess, 2.5 * size) << records;
  }
}

}  // namespace
}  // namespace hackle
