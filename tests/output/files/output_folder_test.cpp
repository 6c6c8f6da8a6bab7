// SPDX-License-Identifier: MIT
#include "output/files/output_folder.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using Choice = OutputFolder::Choice;
using testing::HasSubstr;

RunInputs with_load(const std::string& load) {
  return {"plate", {{"load", load}}, {}};
}

// Takes the folder and leaves a file there, as a run does.
std::string run(OutputFolder folder, std::filesystem::path* path = nullptr) {
  const std::string remark = folder.take();
  write_text(folder.path() / "a.txt", "results");
  folder.finish();
  if (path != nullptr) *path = folder.path();
  return remark;
}

class OutputFolders : public testing::Test {
 protected:
  OutputFolder of(const RunInputs& inputs, Choice choice = Choice::free) const {
    return {folder_.path / "x", choice, inputs};
  }
  std::string name_after(const RunInputs& inputs) const {
    std::filesystem::path path;
    run(of(inputs), &path);
    return path.filename().string();
  }
  const test::Folder folder_;
};

TEST_F(OutputFolders, OtherInputsGetOtherFolders) {
  EXPECT_EQ(name_after(with_load("1MPa")), "x");
  EXPECT_EQ(name_after(with_load("2MPa")), "x-2");
  EXPECT_EQ(name_after({"plate", {}, {"1MPa"}}), "x-3");
  EXPECT_EQ(name_after({"plate", {{"load", "1MPa"}, {"seed", "2"}}, {}}), "x-4");
}

TEST_F(OutputFolders, TheSameInputsAreRecognised) {
  run(of(with_load("1MPa")));
  run(of(with_load("2MPa")));
  EXPECT_EQ(name_after(with_load("2MPa")), "x-2");
  EXPECT_THAT(run(of(with_load("1MPa"))),
              testing::AllOf(HasSubstr("holds the finished run of the same inputs (load=1MPa)"),
                             HasSubstr("made anew")));
  of(with_load("1MPa")).take();  // and is not finished
  EXPECT_EQ(run(of(with_load("1MPa"))), "");
}

TEST_F(OutputFolders, SaysWhereTheFilesGo) {
  EXPECT_EQ(run(of(with_load("1MPa"))), "");
  EXPECT_THAT(run(of(with_load("2MPa"))),
              HasSubstr("this one goes to '" + (folder_.path / "x-2").string() + "'"));
}

TEST_F(OutputFolders, AFolderThatWasNamedIsRefused) {
  run(of(with_load("1MPa"), Choice::named));
  EXPECT_NO_THROW(run(of(with_load("1MPa"), Choice::named)));
  try {
    run(of(with_load("2MPa"), Choice::named));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("load=1MPa"), HasSubstr("load=2MPa"),
                                             HasSubstr("--force")));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_.path / "x-2"));
}

TEST_F(OutputFolders, ARefusedOneStaysRefused) {
  run(of(with_load("1MPa"), Choice::named));
  OutputFolder other = of(with_load("2MPa"), Choice::named);
  for (int k = 0; k < 2; ++k) EXPECT_THROW(other.take(), Error);
  other.finish();
  EXPECT_THAT(read_text(folder_.path / "x" / "plate.inputs.json"), HasSubstr("1MPa"));
}

TEST_F(OutputFolders, ALinkThatLeadsNowhereIsAStrangeMark) {
  std::filesystem::create_directory(folder_.path / "x");
  std::filesystem::create_symlink("nowhere", folder_.path / "x" / "plate.inputs.json");
  EXPECT_EQ(name_after(with_load("1MPa")), "x-2");
}

TEST_F(OutputFolders, ForceOverwritesAndSaysWhat) {
  run(of(with_load("1MPa")));
  EXPECT_THAT(run(of(with_load("2MPa"), Choice::force)), HasSubstr("(load=1MPa) are overwritten"));
  EXPECT_EQ(name_after(with_load("2MPa")), "x");
}

TEST_F(OutputFolders, OtherScriptsMayShareAFolder) {
  run(of(with_load("1MPa"), Choice::named));
  EXPECT_EQ(run(of({"other", {}, {}}, Choice::named)), "");
}

TEST_F(OutputFolders, AStrangeMarkIsThatOfOtherInputs) {
  run(of(with_load("1MPa")));
  for (const char* text : {"", "{", "[1]", "{\"script\": 7}"}) {
    write_text(folder_.path / "x" / "plate.inputs.json", text);
    EXPECT_EQ(name_after(with_load("1MPa")), "x-2") << text;
  }
}

TEST_F(OutputFolders, NothingIsMadeBeforeItIsTaken) {
  const OutputFolder folder = of(with_load("1MPa"));
  folder.finish();
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path));
}

TEST_F(OutputFolders, AFolderThatCannotBeMadeIsAnErrorOfFiles) {
  write_text(folder_.path / "x", "a file");
  try {
    of(with_load("1MPa")).take();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
  }
}

}  // namespace
}  // namespace hackle
