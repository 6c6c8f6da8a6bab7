// SPDX-License-Identifier: MIT
#include "output/files/checkpoint_keeper.hpp"

#include <atomic>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "store/checkpoint.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

class Keeper : public testing::Test {
 protected:
  CheckpointKeeper keeper(double seconds) {
    CheckpointHost host;
    host.place = [this] {
      ++asked_;
      return file_;
    };
    host.continuation = [this] { return std::to_string(asked_); };
    host.settled = [this] { return [this] { ++settled_; }; };
    return {seconds, std::move(host), {}, Talk::quiet};
  }
  std::string kept_hash() const { return read_checkpoint(file_).snapshot.state.hash(); }

  const test::Folder folder_;
  const std::filesystem::path file_ = folder_.path / "run.ckpt";
  int asked_ = 0;
  std::atomic<int> settled_ = 0;
  Simulation simulation_{test::edge_crack(12e6), test::numerics(2e-3, 6e-3), {1}};
};

TEST_F(Keeper, KeepsTheStateFromTimeToTime) {
  for (int k = 1; k <= 3; ++k) {
    CheckpointKeeper often = keeper(1e-9);
    Observer* observers[] = {&often};
    simulation_.run(5e-6, observers);
    EXPECT_EQ(asked_, k);
  }  // which waits for the file
  EXPECT_EQ(read_continuation(file_), "3");
  EXPECT_GE(settled_, 3);
  Simulation on = resume(read_checkpoint(file_), {1});
  EXPECT_GT(on.state().step, 0);
  EXPECT_TRUE(std::filesystem::exists(previous_checkpoint(file_)));
  while (on.state().step < simulation_.state().step) on.step();
  EXPECT_EQ(on.state().hash(), simulation_.state().hash());
}

TEST_F(Keeper, DoesNothingBeforeItsTime) {
  CheckpointKeeper seldom = keeper(1e6);
  Observer* observers[] = {&seldom};
  simulation_.run(20e-6, observers);
  EXPECT_EQ(asked_, 0);
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(Keeper, KeepsTheLastState) {
  CheckpointKeeper seldom = keeper(1e6);
  seldom.keep_last(simulation_);  // which nothing has happened to
  EXPECT_FALSE(std::filesystem::exists(file_));
  simulation_.run(5e-6);
  seldom.keep_last(simulation_);
  EXPECT_EQ(kept_hash(), simulation_.state().hash());
}

TEST_F(Keeper, KeepsNoStateThatHasDiverged) {
  simulation_.run(5e-6);
  State state = simulation_.state();
  state.set_u(3, 3, {std::nan(""), 0.0});
  simulation_.restore(state);
  keeper(1e6).keep_last(simulation_);
  EXPECT_FALSE(std::filesystem::exists(file_));
}

// The run matters more than its checkpoints.
TEST_F(Keeper, AFileThatCannotBeWrittenDoesNotEndTheRun) {
  write_text(folder_.path / "file", "");
  const auto keeper_at = [](auto place) {
    CheckpointHost host;
    host.place = place;
    return CheckpointKeeper(1e-9, std::move(host), {}, Talk::quiet);
  };
  CheckpointKeeper bad = keeper_at([this] { return folder_.path / "file" / "run.ckpt"; });
  Observer* observers[] = {&bad};
  EXPECT_NO_THROW(simulation_.run(20e-6, observers));
  CheckpointKeeper refused =
      keeper_at([]() -> std::filesystem::path { throw Error(ErrorKind::refused, "no"); });
  Observer* others[] = {&refused};
  EXPECT_NO_THROW(simulation_.run(5e-6, others));
  EXPECT_NO_THROW(refused.keep_last(simulation_));
}

}  // namespace
}  // namespace hackle
