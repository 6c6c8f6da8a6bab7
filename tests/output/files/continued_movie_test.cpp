// SPDX-License-Identifier: MIT
// Movies that another program goes on with: they become the files of a run that was never stopped,
// byte for byte.
#include <array>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "movie/kept_frames.hpp"
#include "movie/remux.hpp"
#include "output/files/movie_output.hpp"
#include "output/files/output_names.hpp"
#include "output/report/summary.hpp"
#include "solver/simulation.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int filmed_steps = 9;  // a frame at the start and one after each

// A wave runs in from the upper edge, faster than any that does not break the plate, and is twice
// as fast when the lower one throws it back: the range of the speed widens again and again.
const Simulation& plate_in_motion() {
  static const Simulation simulation = [] {
    Plate plate = test::bare_plate(24, 10);
    plate.loads.tractions.push_back({Edge::top, {2e6, 4e8}});
    return Simulation(plate, test::numerics(), {1});
  }();
  return simulation;
}

MovieOptions film_options() {
  MovieOptions options;
  options.picture.field = "speed";
  options.picture.width = 200;
  options.profile = Profile::preview;
  options.every = plate_in_motion().dt();
  options.hold = 0.2;
  return options;
}

std::unique_ptr<MovieOutput> movie_at(const fs::path& path, int threads = 1) {
  auto movie = std::make_unique<MovieOutput>(path, film_options(), plate_in_motion(), Origin{},
                                             threads, Talk::quiet, std::make_shared<OutputNames>());
  movie->keep_continuable();
  return movie;
}

void film(MovieOutput& movie, Simulation& simulation, int steps) {
  const std::array<Observer*, 1> observers{&movie};
  simulation.run(steps * simulation.dt(), observers);
}

std::string film_uncut(const fs::path& path) {
  Simulation simulation = plate_in_motion();
  const auto movie = movie_at(path);
  film(*movie, simulation, filmed_steps);
  movie->close();
  return read_text(path);
}

// What is left of a program that was killed when it had filmed `steps` and, after the checkpoint,
// `more`: its files as they are while it films.
struct Remains {
  Simulation simulation;
  OutputMark mark;
};
Remains killed_in(const fs::path& folder, const std::string& name, int steps, int more) {
  const fs::path own = folder / "killed";
  Simulation simulation = plate_in_motion();
  const auto movie = movie_at(own / name);
  if (steps >= 0) film(*movie, simulation, steps);
  Remains remains{simulation, movie->mark()};
  movie->settled()();
  if (more > 0) {
    film(*movie, simulation, more);
    movie->settled()();
  }
  fs::create_directories(folder / "copy");
  if (fs::exists(own)) fs::copy(own, folder / "copy", fs::copy_options::recursive);
  return remains;
}

std::string go_on_filming(const fs::path& path, Remains& remains, int threads = 1) {
  const auto movie = movie_at(path, threads);
  movie->continue_from(remains.mark);
  const auto done = static_cast<int>(remains.simulation.state().step);
  film(*movie, remains.simulation, filmed_steps - done);
  movie->close();
  EXPECT_EQ(movie->files(), std::vector{path});
  return read_text(path);
}

class ContinuedMovie : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Each, ContinuedMovie,
                         testing::Values(".mp4", ".webm", ".mkv", ".mov", ".gif", ".apng", ".webp"),
                         [](const auto& tested) { return tested.param.substr(1); });

TEST_P(ContinuedMovie, IsTheUncutOne) {
  const test::Folder folder;
  const std::string name = "a" + GetParam();
  const std::string uncut = film_uncut(folder.path / "uncut" / name);
  Remains remains = killed_in(folder.path, name, 4, 2);
  EXPECT_EQ(remains.mark.pieces, 5);
  EXPECT_TRUE(go_on_filming(folder.path / "copy" / name, remains) == uncut);
  EXPECT_FALSE(fs::exists(partial_name(folder.path / "copy" / name)));
  for (const auto& entry : fs::directory_iterator(folder.path / "copy"))
    EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr("cut_off")));
}

TEST(AContinuedMovie, IsTheUncutOneWhereverItWasCut) {
  const test::Folder folder;
  const std::string uncut = film_uncut(folder.path / "uncut" / "a.mkv");
  for (const int steps : {-1, 0, 1, filmed_steps}) {
    const fs::path here = folder.path / std::to_string(steps);
    Remains remains = killed_in(here, "a.mkv", steps, 0);
    EXPECT_EQ(remains.mark.pieces, steps + 1);
    EXPECT_TRUE(go_on_filming(here / "copy" / "a.mkv", remains) == uncut) << steps;
  }
}

// The range widens before the cut and after it, and so does the window of a deformed plate; else
// the tests above would not see whether the painter goes on.
TEST(AContinuedMovie, HasAPainterThatGoesOn) {
  PictureOptions options = film_options().picture;
  options.deformed = true;
  Simulation simulation = plate_in_motion();
  PlatePainter first(style_of(options, simulation)), second(style_of(options, simulation));
  const int columns = first.adaptation().window.nx;
  double widened_by = 1.0;
  for (int k = 0; k < 2; ++k) {
    for (int n = 0; n < 5; ++n) simulation.step();
    const Image picture = first.paint(shot_of(options, simulation));
    if (k > 0) {
      EXPECT_EQ(second.paint(shot_of(options, simulation)).pixels, picture.pixels);
    }
    const Adaptation adaptation = first.adaptation();
    EXPECT_GT(adaptation.ranges[0].widened_by, widened_by);
    EXPECT_GT(adaptation.window.nx, columns);
    widened_by = adaptation.ranges[0].widened_by;
    second.adapt(adaptation);
  }
}

TEST(AContinuedMovie, IsContinuedAgain) {
  const test::Folder folder;
  const std::string uncut = film_uncut(folder.path / "uncut" / "a.mp4");
  Remains remains = killed_in(folder.path, "a.mp4", 3, 2);
  const fs::path path = folder.path / "copy" / "a.mp4";
  {
    const auto movie = movie_at(path);
    movie->continue_from(remains.mark);
    film(*movie, remains.simulation, 4);
    remains.mark = movie->mark();
    EXPECT_EQ(remains.mark.pieces, 8);
    movie->close();  // as at Ctrl-C
  }
  EXPECT_TRUE(go_on_filming(path, remains) == uncut);
}

// The bytes of H.264 depend on the threads of its encoder: those of the former program are taken.
TEST(AContinuedMovie, DoesNotDependOnTheThreadsOfWhoGoesOn) {
  const test::Folder folder;
  const std::string uncut = film_uncut(folder.path / "uncut" / "a.mp4");
  Remains remains = killed_in(folder.path, "a.mp4", 4, 0);
  EXPECT_TRUE(go_on_filming(folder.path / "copy" / "a.mp4", remains, 3) == uncut);
}

TEST(AContinuedMovie, ThatWasCompleteIsNotTouched) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.gif";
  const std::string uncut = film_uncut(path);
  const auto written = fs::last_write_time(path);
  const auto movie = movie_at(path);
  movie->continue_from({path, filmed_steps + 1, 0.0, filmed_steps + 1, true});
  movie->reserve();
  EXPECT_EQ(movie->files(), std::vector{path});
  EXPECT_TRUE(movie->mark().complete);
  EXPECT_FALSE(fs::exists(partial_name(path)));
  movie->close();
  EXPECT_EQ(fs::last_write_time(path), written);
  EXPECT_EQ(read_text(path), uncut);
}

std::string refusal_to_go_on(const fs::path& path, const OutputMark& mark) {
  try {
    movie_at(path)->continue_from(mark);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    return error.what();
  }
}

TEST(AContinuedMovie, NeedsItsKeptFrames) {
  const test::Folder folder;
  const Remains remains = killed_in(folder.path, "a.mp4", 4, 0);
  const fs::path path = folder.path / "copy" / "a.mp4", kept = kept_frames_name(path);
  EXPECT_EQ(movie_at(path)->kept_files(), std::vector{kept});
  const std::string partial = read_text(partial_name(path));
  fs::resize_file(kept, fs::file_size(kept) - 1);
  EXPECT_THAT(refusal_to_go_on(path, remains.mark), HasSubstr("only 4 of its 5 frames are whole"));
  fs::remove(kept);
  EXPECT_THAT(refusal_to_go_on(path, remains.mark),
              testing::AllOf(HasSubstr("'" + path.string() + "' cannot be continued from"),
                             HasSubstr("No such file"), HasSubstr("--fresh")));
  EXPECT_EQ(read_text(partial_name(path)), partial);  // which may still be rescued
}

TEST(AContinuedMovie, IsNotTakenFromWhoStillFilmsIt) {
  const test::Folder folder;
  Simulation simulation = plate_in_motion();
  const fs::path path = folder.path / "a.mp4";
  const auto movie = movie_at(path);
  film(*movie, simulation, 3);
  movie->settled()();
  EXPECT_THAT(refusal_to_go_on(path, movie->mark()), HasSubstr("is being written by another run"));
  film(*movie, simulation, 2);
  movie->close();
  EXPECT_EQ(length_of_film(path).frames, 6 + 6);  // it holds for 0.2 s
}

TEST(AMovie, KeepsNothingUnlessItIsAsked) {
  const test::Folder folder;
  Simulation simulation = plate_in_motion();
  MovieOutput movie(folder.path / "a.mp4", film_options(), simulation, {}, 1, Talk::quiet,
                    std::make_shared<OutputNames>());
  film(movie, simulation, 2);
  movie.settled()();
  movie.close();
  EXPECT_TRUE(movie.kept_files().empty());
  EXPECT_FALSE(fs::exists(kept_frames_name(folder.path / "a.mp4")));
}

}  // namespace
}  // namespace hackle
