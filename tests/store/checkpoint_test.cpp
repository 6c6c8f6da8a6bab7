// SPDX-License-Identifier: MIT
#include "store/checkpoint.hpp"

#include <cstring>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/hash.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CheckpointFile : public testing::Test {
 protected:
  CheckpointFile() {
    simulation_.run(3.1e-6);
    write_checkpoint(path_, image_of(simulation_, {"a.lua", "-- the script"}));
  }

  std::string refusal() const {
    try {
      resume(read_checkpoint(path_), {1});
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::files) << error.what();
      return error.what();
    }
  }
  // Replaces the file by one of these bytes, whose hash is right.
  void forge(std::string bytes) {
    Hash hash;
    hash.add(std::span<const char>(bytes));
    write_text(path_, bytes + hash.hex());
  }
  std::string bytes() const {
    const std::string all = read_text(path_);
    return all.substr(0, all.size() - 16);
  }

  const test::Folder folder_;
  const fs::path path_ = folder_.path / "a.ckpt";
  Simulation simulation_{test::edge_crack(12e6), test::numerics(2e-3, 6e-3), {1}};
};

TEST_F(CheckpointFile, HoldsScriptSceneAndState) {
  const Checkpoint checkpoint = read_checkpoint(path_);
  EXPECT_EQ(checkpoint.origin.script_name, "a.lua");
  EXPECT_EQ(checkpoint.origin.script_text, "-- the script");
  EXPECT_EQ(checkpoint.inputs.plate.cracks.size(), 1U);
  EXPECT_EQ(checkpoint.snapshot.state.hash(), simulation_.state().hash());
  EXPECT_EQ(checkpoint.snapshot.aim.end_time, 3.1e-6);
}

TEST(CheckpointSize, IsThatOfTheState) {
  const test::Folder folder;
  for (const Precision precision : {Precision::f32, Precision::f64}) {
    Numerics numerics = test::numerics(0.25e-3, 1e-3);
    numerics.precision = precision;
    const Simulation simulation(test::edge_crack(12e6), numerics, {1});
    write_checkpoint(folder.path / "a.ckpt", image_of(simulation, {}));
    EXPECT_LE(static_cast<double>(fs::file_size(folder.path / "a.ckpt")),
              1.05 * static_cast<double>(simulation.state().bytes()));
  }
}

TEST_F(CheckpointFile, TheOneBeforeIsKept) {
  const std::string before = read_text(path_);
  simulation_.run(1e-6);
  write_checkpoint(path_, image_of(simulation_, {}));
  EXPECT_EQ(read_text(previous_checkpoint(path_)), before);
  EXPECT_EQ(previous_checkpoint("x/run.ckpt"), fs::path("x/run_prev.ckpt"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path), {}), 2);
}

TEST_F(CheckpointFile, IsRefusedWhereverItIsCut) {
  const std::string whole = read_text(path_);
  for (std::size_t size = 0; size < whole.size(); size += size < 5000 ? 23 : 997) {
    write_text(path_, whole.substr(0, size));
    EXPECT_THAT(refusal(), HasSubstr("file '" + path_.string())) << size;
  }
}

TEST_F(CheckpointFile, IsRefusedWhicheverByteHasChanged) {
  const std::string whole = read_text(path_);
  for (std::size_t at = 0; at < whole.size(); at += at < 5000 ? 7 : 499) {
    std::string other = whole;
    other[at] = static_cast<char>(other[at] ^ (1 << (at % 8)));
    write_text(path_, other);
    EXPECT_NE(refusal(), "") << at;
  }
  std::string last = whole;
  last.back() = last.back() == '0' ? '1' : '0';
  write_text(path_, last);
  EXPECT_THAT(refusal(), HasSubstr("it is damaged"));
}

TEST_F(CheckpointFile, ThePreviousOneIsOfferedIfItIsWhole) {
  simulation_.run(1e-6);
  write_checkpoint(path_, image_of(simulation_, {}));
  const std::string previous = previous_checkpoint(path_).string();
  write_text(path_, read_text(path_).substr(1000));
  EXPECT_THAT(refusal(), HasSubstr("the one before it is whole: '" + previous + "'"));
  write_text(previous, "gone");
  EXPECT_THAT(refusal(), testing::Not(HasSubstr("the one before")));
}

// Files whose bytes are as they were written, by somebody with bad intentions.
TEST_F(CheckpointFile, ForgedOnesAreRefused) {
  const std::string good = bytes();
  const auto with = [&](const std::string& was, const std::string& is) {
    std::string text = good;
    const std::size_t at = text.find(was);
    EXPECT_NE(at, std::string::npos) << was;
    text.replace(at, was.size(), is);
    const std::size_t first = text.find('\n') + 1, second = text.find('\n', first);
    const std::size_t head = std::stoul(text.substr(first, second - first));
    return text.replace(first, second - first, std::to_string(head + is.size() - was.size()));
  };
  const std::vector<std::string> forged{
      "",
      "Hackle checkpoint 2\n",
      "Hackle checkpoint 2\n99999999999999999999999\n{}",
      "Hackle checkpoint 2\n2\n{}",
      "Hackle checkpoint 2\n-2\n{}",
      "Hackle checkpoint 2\n2\n{}",
      good.substr(0, good.size() - 8),
      with("\"ux\":", "\"ux\":9"),
      with("\"ux\":", "\"ux\":-"),
      with("\"bonds\":", "\"bonds\":1"),
      with("\"precision\":\"f64\"", "\"precision\":\"f32\""),
      with("\"start\":0", "\"start\":-1"),
      with("\"start\":0", "\"start\":\"x\""),
      with("\"discs\":[]", "\"discs\":[[[0,0],[0,0]]]"),
      with("\"borne\":[]", "\"borne\":[[999999,0,[0,0],1]]"),
      with("\"borne\":[]", "\"borne\":[[-1,0,[0,0],1]]"),
      with("\"borne\":[]", "\"borne\":[7]"),
      with("\"max_energy\":", "\"max_energy\":1e999"),
      with("\"lattice_hash\":\"", "\"lattice_hash\":\"0"),
      with("\\\"width_m\\\": 0.1", "\\\"width_m\\\": 1e9"),
  };
  for (const std::string& file : forged) {
    forge(file);
    EXPECT_NE(refusal(), "") << file.substr(0, 200);
  }
  forge(good);
  EXPECT_EQ(refusal(), "");
}

// A value that is no number, and a bond that the plate never had.
TEST_F(CheckpointFile, ForgedArraysAreRefused) {
  const std::string good = bytes();
  const std::size_t words = simulation_.state().bonds.words().size();
  std::string strange = good;
  std::memset(strange.data() + strange.size() - 4 * words, 0xFF, 4 * words);
  forge(strange);
  EXPECT_NE(refusal(), "");
  std::string nan = good;
  const std::size_t arrays = nan.size() - 4 * words - 4 * 8 * simulation_.state().layout.size();
  std::memset(nan.data() + arrays, 0xFF, 8 * simulation_.state().layout.size());
  forge(nan);
  EXPECT_NE(refusal(), "");
}

TEST_F(CheckpointFile, AFolderThatCannotBeWrittenIsAnErrorOfFilesAndNothingIsLost) {
  write_text(folder_.path / "file", "");
  try {
    write_checkpoint(folder_.path / "file" / "a.ckpt", image_of(simulation_, {}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
  }
  EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace hackle
