// SPDX-License-Identifier: MIT
// hackle export.
#include <cstdlib>
#include <sstream>

#include <gmock/gmock.h>

#include "app/lammps_peer.hpp"
#include "app/program.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "support/skipping.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ExportCommand : public testing::Test {
 protected:
  ExportCommand() {
    write_text(folder_.path / "a.lua",
               test::scene + "s:record { 'a.h5', every = 1*us } s:run(3*us) s:save { 'a.ckpt' }");
    program_.run({"run", "a.lua", "-o", "."});
  }
  test::Ended exported(std::vector<std::string> words) const {
    words.insert(words.begin(), "export");
    return program_.run(words);
  }
  std::string text(const char* file) const { return read_text(folder_.path / file); }
  bool is_there(const char* file) const { return std::filesystem::exists(folder_.path / file); }

  test::Folder folder_;
  test::Program program_{folder_};
};

TEST_F(ExportCommand, WritesStatesBesideWhereItIsCalled) {
  const test::Ended csv =
      exported({"a.h5", "--csv", "--times", "1us,2e-6", "--fields", "stress_1"});
  EXPECT_EQ(csv.code, 0) << csv.err;
  EXPECT_EQ(csv.out, "");
  EXPECT_THAT(csv.err, HasSubstr("wrote a.csv"));
  EXPECT_THAT(text("a.csv"), StartsWith("time (s),x (m),y (m),stress_1 (Pa)\n"));
  std::istringstream lines(text("a.csv"));
  int count = 0;
  for (std::string line; std::getline(lines, line);) ++count;
  EXPECT_EQ(count, 1 + 2 * 1000);
  EXPECT_EQ(exported({"a.ckpt", "--vtk", "-o", "new/b.vtk"}).code, 0);
  EXPECT_THAT(text("new/b.vtk"), StartsWith("# vtk DataFile Version 3.0\n"));
  EXPECT_EQ(exported({"a.h5", "--vtkhdf", "-q"}).err, "");
  EXPECT_THAT(text("a.vtkhdf"), StartsWith("\x89HDF"));
  EXPECT_EQ(exported({"a.h5", "--vtk", "--every", "1us"}).code, 0);
  EXPECT_TRUE(is_there("a_0003.vtk"));
}

TEST_F(ExportCommand, WritesADeckThatLammpsRuns) {
  HACKLE_NEEDS(lammps_is_installed(), "lmp is not on the PATH");
  const test::Ended ended = exported({"a.h5", "--lammps", "-o", "deck.in"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("breaking = \"next_step\""));
  const std::string folder = shell_word(folder_.path.string());
  EXPECT_EQ(
      std::system(fmt::format("cd {} && lmp -in deck.in -log none -screen none > said 2>&1", folder)
                      .c_str()),
      0)
      << text("said");
  EXPECT_THAT(text("nodes.dump"), HasSubstr("ITEM: NUMBER OF ATOMS\n1000\n"));
}

TEST_F(ExportCommand, EndsWithTheCodeOfTheError) {
  write_text(folder_.path / "held.lua",
             test::scene + "s:clamp { edge = 'left', depth = 2*mm } s:save { 'held.ckpt' }");
  program_.run({"run", "held.lua", "-o", "."});
  struct Case {
    std::vector<std::string> words;
    int code;
    const char* message;
  };
  for (const Case& c : {
           Case{{"--csv"}, 2, "RUN is required"},
           {{"a.h5"}, 2, "name one of --csv, --vtk, --vtkhdf and --lammps"},
           {{"a.h5", "--csv", "--vtk"}, 2, "name one of"},
           {{"a.h5", "--csv", "--times", "soon"}, 2, "soon"},
           {{"a.h5", "--csv", "--times", "1us", "--every", "1us"}, 2, "excludes"},
           {{"a.h5", "--csv", "-o", "a.h5"}, 2, "is the run itself"},
           {{"a.h5", "--csv", "--every", "0"}, 4, "it must be above 0 s"},
           {{"a.h5", "--csv", "--fields", "sped"}, 4, "did you mean 'speed'?"},
           {{"held.ckpt", "--lammps"}, 4, "supports"},
           {{"none.h5", "--csv"}, 5, "there is no such file"},
           {{"a.lua", "--csv"}, 5, "neither a run file nor a checkpoint"},
       }) {
    const test::Ended ended = exported(c.words);
    EXPECT_EQ(ended.code, c.code) << c.message << ": " << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(c.message));
  }
  EXPECT_FALSE(is_there("a.csv"));
  EXPECT_FALSE(is_there("held.in"));
}

}  // namespace
}  // namespace hackle
