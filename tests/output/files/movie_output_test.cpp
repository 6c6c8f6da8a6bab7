// SPDX-License-Identifier: MIT
// Movies of runs.
#include "output/files/movie_output.hpp"

#include <functional>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/partial_file.hpp"
#include "base/version.hpp"
#include "movie/make_film.hpp"
#include "movie/remux.hpp"
#include "output/report/summary.hpp"
#include "output/run/run.hpp"
#include "solver/simulation.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const Origin origin{"scripts/edge.lua", "print 'edge'"};

hackle::Run small_run(Talk talk = Talk::quiet) {
  return hackle::Run(test::bare_plate(20, 20), test::numerics(), {}, talk, origin);
}

MovieOptions options() {
  MovieOptions chosen;
  chosen.picture.width = 320;
  chosen.every = 1e-6;
  return chosen;
}

std::string refusal_of(const fs::path& path, const MovieOptions& chosen) {
  try {
    small_run().movie(path, chosen);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
}

TEST(MovieOutput, HoldsItsLastFrameForASecond) {
  const test::Folder folder;
  MovieOptions chosen = options();
  chosen.fps = 10.0;
  for (const double hold : {0.0, 0.5, 1.0}) {
    chosen.hold = hold;
    hackle::Run run = small_run();
    const fs::path path = folder.path / "a.mkv";
    EXPECT_EQ(run.movie(path, chosen), path);
    run.run(3e-6);
    run.close();
    EXPECT_EQ(length_of_film(path).frames, 4 + std::llround(10.0 * hold));
  }
  EXPECT_EQ(MovieOptions{}.hold, 1.0);
}

TEST(MovieOutput, SaysWhichScriptMadeItAndWithWhat) {
  const test::Folder folder;
  hackle::Run run = small_run();
  run.movie(folder.path / "edge.mp4", options());
  run.run(1e-6);
  run.close();
  const std::string bytes = read_text(folder.path / "edge.mp4");
  Hash hash;
  hash.add(std::span<const char>(origin.script_text));
  EXPECT_THAT(bytes, HasSubstr("Made by Hackle " + std::string(version())));
  EXPECT_THAT(bytes, HasSubstr("from edge.lua, XXH3 " + hash.hex()));
}

TEST(MovieOutput, QualityIsThatOfItsOptions) {
  const test::Folder folder;
  std::uintmax_t size = 0;
  for (const int crf : {51, 1}) {
    MovieOptions chosen = options();
    chosen.crf = crf;
    hackle::Run run = small_run();
    run.movie(folder.path / "a.webm", chosen);
    run.run(2e-6);
    run.close();
    EXPECT_GT(fs::file_size(folder.path / "a.webm"), size);
    size = fs::file_size(folder.path / "a.webm");
  }
}

TEST(MovieOutput, RefusesWhatCannotBe) {
  const test::Folder folder;
  MovieOptions chosen = options();
  EXPECT_THAT(refusal_of(folder.path / "a.mp5", chosen), HasSubstr("did you mean '.mp4'?"));
  chosen.fps = 241.0;
  EXPECT_THAT(refusal_of(folder.path / "a.mp4", chosen), HasSubstr("between 1 and 240"));
  chosen.fps = 100.0;
  chosen.crf = 20;
  const std::string both = refusal_of(folder.path / "a.gif", chosen);
  EXPECT_THAT(both, HasSubstr("fps is 100, in .gif"));
  EXPECT_THAT(both, HasSubstr("crf has no meaning in .gif"));
}

// Leaves a partial movie like a killed run.
void leave_half_a_film(const fs::path& path) {
  MovieFormat format{64, 48};
  const auto film = make_film(path, format);
  for (int k = 0; k < 5; ++k) {
    Image image(64, 48);
    image.pixels[static_cast<std::size_t>(40 * k)] = 255;
    film->add(image);
  }
}

TEST(MovieOutput, KeepsWhatAKilledRunHadFilmedAndSaysSo) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.gif";
  leave_half_a_film(path);
  hackle::Run run = small_run(Talk::plain);
  run.movie(path, options());
  EXPECT_FALSE(fs::exists(folder.path / "a.cut_off.gif"));  // nothing before the first step
  testing::internal::CaptureStderr();
  run.run(2e-6);
  EXPECT_THAT(
      testing::internal::GetCapturedStderr(),
      HasSubstr("its 5 frames, 0.17 s, are kept as '" + (folder.path / "a.cut_off.gif").string()));
  run.close();
  EXPECT_EQ(length_of_film(folder.path / "a.cut_off.gif").frames, 5);
  EXPECT_TRUE(fs::exists(path));
}

TEST(MovieOutput, EstimatesWhatItsKindTakes) {
  const test::Folder folder;
  const Simulation simulation(test::bare_plate(20, 20), test::numerics());
  const auto bytes = [&](const char* name) {
    return MovieOutput(folder.path / name, options(), simulation, origin, 1, Talk::quiet,
                       std::make_shared<OutputNames>())
        .expected(100e-6, 1000)
        .bytes;
  };
  EXPECT_GT(bytes("a.mkv"), 5.0 * bytes("a.mp4"));
}

// At 25 frames per second and a microsecond between frames, a second of the movie is 25 us.
TEST(MovieOutput, SaysHowMuchSlowerItIs) {
  MovieOptions options;
  options.every = 1e-6;
  options.fps = 25.0;
  EXPECT_DOUBLE_EQ(slow_motion_of(options), 1.0 / 25e-6);
}

}  // namespace
}  // namespace hackle
