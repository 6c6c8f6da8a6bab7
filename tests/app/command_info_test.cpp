// SPDX-License-Identifier: MIT
// hackle info FILE and hackle diff A B.
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class FilesOfRuns : public testing::Test {
 protected:
  FilesOfRuns() {
    write_text(folder_.path / "a.lua",
               test::scene +
                   "s:record { 'a.h5', every = 1*us } s:movie { 'a.mp4', every = 1*us, "
                   "width = 320 } s:run(3*us) s:save { 'a.ckpt' }");
    program_.run({"run", "a.lua", "-o", "."});
  }
  test::Ended info(const std::string& file) const { return program_.run({"info", file}); }
  nlohmann::json json(std::vector<std::string> words) const {
    words.emplace_back("--json");
    return nlohmann::json::parse(program_.run(words).out);
  }

  test::Folder folder_;
  test::Program program_{folder_};
};

TEST_F(FilesOfRuns, SayWhatTheyAreAndHowToGoOn) {
  const test::Ended run = info("a.h5");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* text :
       {"run file         a.h5", "made by Hackle", "a.lua", "plate 100 x 40 mm",
        "points (0 m, 20 mm) (50 mm, 20 mm)", "edge top, stress (0 Pa, 12 MPa)", "50 x 20 nodes",
        "spacing 2 mm", "complete: 4 records from 0 s to 3 us", "damage", "hackle render a.h5"})
    EXPECT_THAT(run.out, HasSubstr(text));
  const test::Ended saved = info("a.ckpt");
  for (const char* text : {"checkpoint       a.ckpt", "at 3 us, step 4", "load \"a.ckpt\""})
    EXPECT_THAT(saved.out, HasSubstr(text));
  const test::Ended movie = info("a.mp4");
  for (const char* text : {"movie            a.mp4", "a.lua", "of 320 x"})
    EXPECT_THAT(movie.out, HasSubstr(text));
}

TEST_F(FilesOfRuns, HaveDocumentedKeys) {
  for (const char* file : {"a.h5", "a.ckpt", "a.mp4"}) {
    const nlohmann::json about = json({"info", file});
    EXPECT_EQ(about["schema"], 1);
    EXPECT_EQ(about["file"], file);
    EXPECT_EQ(about["bytes"], std::filesystem::file_size(folder_.path / file));
    EXPECT_EQ(about["script"], "a.lua");
    EXPECT_FALSE(about["next"].empty());
  }
  const nlohmann::json run = json({"info", "a.h5"});
  EXPECT_EQ(run["times_s"].size(), run["records"].get<std::size_t>());
  EXPECT_EQ(run["complete"], true);
  EXPECT_EQ(run["columns"], 50);
  EXPECT_EQ(run["scene"]["width_m"], 0.1);
  EXPECT_EQ(run["numerics"]["spacing_m"], 0.002);
  EXPECT_GT(run["fields"]["displacement"].get<int>(), 0);
  const nlohmann::json saved = json({"info", "a.ckpt"});
  std::uint64_t bytes = 0;
  for (const auto& [name, size] : saved["fields"].items()) bytes += size.get<std::uint64_t>();
  EXPECT_EQ(bytes, saved["bytes"].get<std::uint64_t>());
  EXPECT_EQ(saved["hash"].get<std::string>().size(), 16U);
}

TEST_F(FilesOfRuns, WithoutAFileInfoTellsOfTheProgram) {
  const test::Ended ended = program_.run({"info"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, StartsWith("hackle "));
}

TEST_F(FilesOfRuns, OtherFilesAreRefused) {
  write_text(folder_.path / "text.mp4", "no movie");
  const std::string whole = test::Program::text_of(folder_.path / "a.ckpt");
  std::ofstream(folder_.path / "cut.ckpt") << whole.substr(0, whole.size() / 2);
  for (const auto& [file, message] : {std::pair{"none.h5", "there is no such file"},
                                      {"a.lua", "neither a run file"},
                                      {"text.mp4", "is no H.264 movie"},
                                      {"cut.ckpt", "damaged"},
                                      {".", "it is a folder"}}) {
    const test::Ended ended = info(file);
    EXPECT_EQ(ended.code, 5) << file;
    EXPECT_EQ(ended.out, "") << file;
    EXPECT_THAT(ended.err, HasSubstr(message));
  }
}

TEST_F(FilesOfRuns, AreEqualOrDiffer) {
  std::string scene = test::scene;
  scene.replace(scene.find("12*MPa"), 6, "14*MPa");
  write_text(folder_.path / "b.lua", scene + "s:record { 'b.h5', every = 1*us } s:run(3*us)");
  program_.run({"run", "b.lua", "-o", "."});
  const test::Ended same = program_.run({"diff", "a.h5", "a.ckpt"});
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_THAT(same.out, StartsWith("equal: "));
  const test::Ended other = program_.run({"diff", "a.h5", "b.h5"});
  EXPECT_EQ(other.code, 1) << other.err;
  for (const char* text :
       {"1 differ\n", "tractions[1].stress: (0 Pa, 12 MPa) against (0 Pa, 14 MPa)", "4 in common",
        "displacement", "node ("})
    EXPECT_THAT(other.out, HasSubstr(text));
  const nlohmann::json found = json({"diff", "a.h5", "b.h5"});
  EXPECT_EQ(found["equal"], false);
  EXPECT_EQ(found["inputs"].size(), 1U);
  EXPECT_NEAR(found["first_time_s"].get<double>(), 1e-6, 1e-12);
  EXPECT_EQ(found["fields"][0]["name"], "displacement");
  EXPECT_EQ(found["fields"][0]["node"].size(), 2U);
  EXPECT_EQ(json({"diff", "a.h5", "a.h5"})["equal"], true);
  EXPECT_EQ(program_.run({"diff", "a.h5", "a.lua"}).code, 5);
  EXPECT_EQ(program_.run({"diff", "a.h5"}).code, 2);
}

}  // namespace
}  // namespace hackle
