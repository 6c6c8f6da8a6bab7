// SPDX-License-Identifier: MIT
#include "output/files/replay.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "output/files/panels.hpp"
#include "output/picture/field_choice.hpp"
#include "output/picture/painting.hpp"
#include "solver/simulation.hpp"
#include "store/run_file.hpp"
#include "support/folder.hpp"
#include "support/pixels.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Records a small plate under this stress, a record every microsecond.
std::shared_ptr<Recording> recorded(const fs::path& path, double stress, int records, int nx = 40) {
  Plate plate = test::bare_plate(nx, 20);
  plate.loads.tractions.push_back({Edge::top, {0.0, stress}});
  Simulation simulation(plate, test::numerics(), {1});
  RunFile file(path, simulation, {"a.lua", ""});
  for (int k = 0; k < records; ++k) {
    file.add(simulation);
    if (k + 1 < records) simulation.run(1e-6);
  }
  file.finish();
  return std::make_shared<Recording>(path);
}

class ReplayTest : public testing::Test {
 protected:
  std::shared_ptr<Recording> a(int records = 5) {
    return recorded(folder_.path / "a.h5", 5e6, records);
  }
  std::shared_ptr<Recording> b(int records = 3) {
    return recorded(folder_.path / "b.h5", 10e6, records, 24);
  }
  test::Folder folder_;
};

std::string refusal(const Tiles& tiles, const Moments& moments) {
  try {
    frame_times("movie", tiles, moments);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
}

TEST_F(ReplayTest, FramesLieEvenlyOneForEachRecord) {
  const auto recording = a();
  const std::vector<double>& records = recording->times();
  const std::vector<double> times = frame_times("movie", {{recording, ""}}, {});
  ASSERT_EQ(times.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(times[k], records.back() * static_cast<double>(k) / 4, 1e-15);
    EXPECT_EQ(recording->nearest(times[k]), k);
  }
}

TEST_F(ReplayTest, FramesGoFromToAsAsked) {
  const Tiles tiles{{a(), ""}};
  EXPECT_THAT(frame_times("movie", tiles, {1e-6, 2e-6, 0.25e-6}),
              testing::Pointwise(testing::DoubleEq(), {1e-6, 1.25e-6, 1.5e-6, 1.75e-6, 2e-6}));
  EXPECT_THAT(refusal(tiles, {2e-6, 1e-6, {}}), HasSubstr("from must come before to"));
  EXPECT_THAT(refusal(tiles, {{}, {}, 0.0}), HasSubstr("every is 0 s"));
  EXPECT_THAT(refusal(tiles, {{}, {}, 1e-12}), HasSubstr("more than 100000 frames"));
}

TEST_F(ReplayTest, OneRecordIsOneFrame) {
  EXPECT_EQ(frame_times("movie", {{a(1), ""}}, {}).size(), 1U);
}

TEST_F(ReplayTest, ACommonClockLastsAsLongAsTheLongestRun) {
  const auto longer = a(), shorter = b();
  const std::vector<double> times = frame_times("both", {{shorter, ""}, {longer, ""}}, {});
  EXPECT_EQ(times.size(), 5U);
  EXPECT_DOUBLE_EQ(times.back(), longer->times().back());
  EXPECT_EQ(shorter->nearest(times.back()), 2U);  // stays in its final state
}

TEST_F(ReplayTest, TheCommonRangeHoldsForEverythingThatIsSeen) {
  const auto one = a(), other = b();
  const Tiles tiles{{one, ""}, {other, ""}};
  PictureOptions options;
  options.field = "speed";
  options.percentile = 100.0;
  const PictureOptions found = with_common_range(options, tiles, frame_times("x", tiles, {}));
  ASSERT_TRUE(found.range);
  EXPECT_FALSE(found.percentile);
  float max = 0.0F;
  for (const auto& recording : {one, other})
    for (std::size_t k = 0; k < recording->times().size(); ++k) {
      recording->go_to(k);
      for (const float value : shot_of(options, recording->view()).values)
        max = std::max(max, value);
    }
  EXPECT_FLOAT_EQ(static_cast<float>(found.range->max), max);
}

TEST_F(ReplayTest, WithoutAPercentileTheWidestRangeThatSuitsHolds) {
  Plate plate = test::bare_plate(40, 20);
  plate.material.G0 *= 4.0;  // critical stretch and stress are twice as large
  Simulation tough(plate, test::numerics(), {1});
  {
    RunFile file(folder_.path / "tough.h5", tough, {});
    file.add(tough);
    file.finish();
  }
  const Tiles tiles{{a(1), ""}, {std::make_shared<Recording>(folder_.path / "tough.h5"), ""}};
  PictureOptions options;
  options.field = "von_mises";
  const Ends usual = usual_ends(options, tough);
  EXPECT_DOUBLE_EQ(with_common_range(options, tiles, {}).range->max, usual.max);
  options.range = Ends{1.0, 2.0};
  EXPECT_EQ(with_common_range(options, tiles, {}).range->max, 2.0);
}

TEST_F(ReplayTest, FilmsOneRun) {
  MovieOptions options;
  options.picture.width = 320;
  options.picture.percentile = 99.0;
  options.picture.field = "speed";
  film(a(), folder_.path / "a.mp4", options, {}, 1, Talk::quiet, std::make_shared<OutputNames>());
  EXPECT_GT(fs::file_size(folder_.path / "a.mp4"), 1000U);
}

TEST_F(ReplayTest, FilmsSeveralOfDifferentShapes) {
  MovieOptions options;
  options.picture.width = 320;
  film_side_by_side({{a(), "one"}, {b(), "other"}}, folder_.path / "ab.mp4", options, {},
                    {.columns = 2}, 1, Talk::quiet, OutputNames());
  EXPECT_GT(fs::file_size(folder_.path / "ab.mp4"), 1000U);
}

TEST_F(ReplayTest, AnInterruptedMovieIsComplete) {
  struct Interrupted {
    Interrupted() { request_interrupt(); }
    ~Interrupted() { clear_interrupt(); }
  };
  const auto recording = a();
  MovieOptions options;
  options.picture.width = 320;
  const Interrupted now;
  try {
    film(recording, folder_.path / "a.mp4", options, {}, 1, Talk::quiet,
         std::make_shared<OutputNames>());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
    EXPECT_THAT(error.what(), HasSubstr("interrupted after frame 0 of 5"));
  }
}

TEST_F(ReplayTest, ASheetHasARowForEachRunAndAColumnForEachTime) {
  PictureOptions options;
  options.width = 320;
  SheetLayout layout;
  layout.width = 320;
  const auto one = a(), other = b();
  const Tiles tiles{{one, ""}, {other, ""}};
  const Image grid = sheet_of(tiles, {1e-6, 2e-6, 3e-6}, options, layout);
  const int gap = 13;  // 4 % of the width
  EXPECT_EQ(grid.width, 3 * (320 + gap) + gap);
  layout.columns = 2;
  const Image ends = sheet_of(tiles, {}, options, layout);
  EXPECT_EQ(ends.width, 2 * (320 + gap) + gap);
  options.overlay.bar = options.overlay.scale_bar = false;  // without a legend
  const Image bare = sheet_of(tiles, {1e-6, 2e-6, 3e-6}, options, layout);
  layout.columns = 2;
  EXPECT_GT(grid.height, bare.height);
  EXPECT_LT(bare.height - gap, 2 * (sheet_of(tiles, {}, options, layout).height - gap) + 1)
      << "two rows, each as high as its run";
  layout.columns = 1;
  const Image list = sheet_of({{one, ""}}, {1e-6, 2e-6}, options, layout);
  EXPECT_EQ(list.width, 320 + 2 * gap);
}

// Runs of 20 and 12 mm: the larger is drawn as large as it can, the other to the same scale.
TEST_F(ReplayTest, PanelsShareOneScale) {
  PictureOptions options;
  options.width = 320;
  options.overlay.title = "";
  options.overlay.clock = options.overlay.bar = options.overlay.scale_bar = false;
  options.look = Look::light;
  options.colours = "viridis";
  SheetLayout layout;
  layout.width = 320;
  layout.columns = 2;
  const Image sheet = sheet_of({{a(), ""}, {b(), ""}}, {}, options, layout);
  const Colour least = load_colour_map("viridis").colours.front();
  const int left = test::count_pixels(sheet, {0, 60, sheet.width / 2, 1}, [&](int x, int y) {
    return test::pixel(sheet, x, y)[2] == least.red;
  });
  const int right =
      test::count_pixels(sheet, {sheet.width / 2, 60, sheet.width / 2, 1},
                         [&](int x, int y) { return test::pixel(sheet, x, y)[2] == least.red; });
  EXPECT_NEAR(left, 280, 20);
  EXPECT_NEAR(right, 24.0 / 40.0 * left, 2);
}

TEST(PanelNames, AreThoseOfTheFilesOrOfTheirFolders) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(panel_names({"a/one.h5", "a/two.h5"}), (Names{"one", "two"}));
  EXPECT_EQ(panel_names({"out/2MPa/run.h5", "out/4MPa/run.h5"}), (Names{"2MPa", "4MPa"}));
  EXPECT_EQ(panel_names({"a/run.h5", "a/run.h5", "b/run.h5"}), (Names{"a/run", "a/run", "b/run"}));
  EXPECT_EQ(panel_names({"run.h5", "run.h5"}), (Names{"run", "run"}));
}

TEST_F(ReplayTest, APictureOnASheetShowsTheRecordOfItsTime) {
  PictureOptions options;
  options.width = 320;
  options.field = "speed";
  SheetLayout layout;
  layout.width = 320;
  const Tiles tiles{{a(), ""}};
  const Image early = sheet_of(tiles, {0.0}, options, layout);
  EXPECT_EQ(sheet_of(tiles, {0.2e-6}, options, layout).pixels, early.pixels);
  EXPECT_NE(sheet_of(tiles, {4e-6}, options, layout).pixels, early.pixels);
  EXPECT_EQ(sheet_of(tiles, {}, options, layout).pixels,
            sheet_of(tiles, {4e-6}, options, layout).pixels);
}

}  // namespace
}  // namespace hackle
