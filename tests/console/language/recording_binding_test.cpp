// SPDX-License-Identifier: MIT
#include "console/language/recording_binding.hpp"

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RecordingBindingTest : public testing::Test {
 protected:
  RecordingBindingTest() { console_.evaluate(test::scene + test::recorded); }

  std::string value(const std::string& text) { return console_.evaluate(text).at(0); }
  std::string refusal(const std::string& text) {
    try {
      console_.evaluate(text);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }
  bool made(const char* name) const {
    return fs::is_regular_file(folder_.path / name) && fs::file_size(folder_.path / name) > 500;
  }

  test::Folder folder_;
  Console console_{test::quiet(folder_.path)};
};

TEST_F(RecordingBindingTest, SaysWhatIsRecorded) {
  EXPECT_EQ(value("#r.times"), "2");
  EXPECT_EQ(value("r.times[1]"), "0.0");
  EXPECT_EQ(value("r.times[2] == 1*us"), "true");
  EXPECT_EQ(value("r.nodes"), "1000");
  EXPECT_EQ(value("r.file"), (folder_.path / "r.h5").string());
  EXPECT_THAT(value("r"), HasSubstr("2 records from 0 s to 1 us"));
  EXPECT_THAT(value("r"), HasSubstr(", 1 000 nodes, plate 100 x 40 mm, Duran 50 glass"));
}

TEST_F(RecordingBindingTest, MakesFramesAndMovies) {
  console_.evaluate("r:frame { 'a.png', width = 320, time = 0, field = 'stress_1' }");
  console_.evaluate("r:frame { 'sub/b.png', width = 320, percentile = 98, field = 'speed' }");
  console_.evaluate("r:movie { 'a.mp4', width = 320, percentile = 98, field = 'speed' }");
  console_.evaluate("r:movie { 'b.mp4', width = 320, every = 0.1*us, from = 0.2*us, to = 0.4*us }");
  for (const char* name : {"a.png", "sub/b.png", "a.mp4", "b.mp4"}) EXPECT_TRUE(made(name)) << name;
}

// A run that went no further shows the same picture as the record of its end.
TEST_F(RecordingBindingTest, AFrameIsThatOfTheRunItself) {
  console_.evaluate("s:run(1*us) s:frame { 'live.png', field = 'damage', width = 320 }");
  console_.evaluate("r:frame { 'recorded.png', field = 'damage', width = 320 }");
  EXPECT_EQ(read_text(folder_.path / "live.png"), read_text(folder_.path / "recorded.png"));
}

TEST_F(RecordingBindingTest, PutsRunsSideBySideAndOnSheets) {
  console_.evaluate("side_by_side { 'both.mp4', recordings = { r, r }, width = 320 }");
  console_.evaluate("contact_sheet { 'a.png', recordings = { r, r }, times = {0, 1*us} }");
  console_.evaluate("contact_sheet { 'b.png', recordings = { r }, width = 64, field = 'speed' }");
  for (const char* name : {"both.mp4", "a.png", "b.png"}) EXPECT_TRUE(made(name)) << name;
}

TEST_F(RecordingBindingTest, IsShown) {
  testing::internal::CaptureStdout();
  console_.evaluate("show(r) show(r, { time = 0, field = 'speed' }) show { r, time = 0 }");
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_THAT(text, HasSubstr("damage at 1 us"));
  EXPECT_THAT(text, HasSubstr("speed at 0 s"));
  EXPECT_TRUE(made("show_3.png"));
}

TEST_F(RecordingBindingTest, RefusesBadInput) {
  struct Bad {
    const char* text;
    const char* message;
  };
  for (const Bad& bad : {
           Bad{"recording 'none.h5'", "there is no such file"},
           {"recording {}", "recording: file is missing"},
           {"recording '../r.h5'", "recording: "},
           {"r:frame { 'a.png', range = {0, 1}, percentile = 99 }", "range and percentile"},
           {"r:frame { 'a.png', percentile = 10 }", "percentile is 10"},
           {"r:movie { 'a.mp4', from = 1, to = 0 }", "from must come before to"},
           {"r:movie { 'a.mp4', every = 1e-15 }", "more than 100000 frames"},
           {"r:movie { 'a.mp4', zoom = {1, 1, 10*mm} }", "zoom shows nothing of the plate"},
           {"s:movie { 'a.mp4', every = 1*us, percentile = 99 }",
            "percentile needs to know what will be seen (give a range; or record the run"},
           {"show(s, { time = 0 })", "time is for recordings"},
           {"show(r, { load_curve = true })", "show: a recording does not hold the loads"},
           {"r:frame { 'a.png', load_curve = true }", "frame: a recording does not hold the loads"},
           {"r:movie { 'a.mp4', background = 'transparent' }", "cannot be transparent"},
           {"side_by_side { 'a.mp4', recordings = { r }, titles = { 'a', 'b' } }",
            "there are 2 titles for 1 recordings"},
           {"contact_sheet { 'a.png', recordings = { r }, pictures = { 'b.png' } }",
            "pictures and recordings are given"},
           {"contact_sheet { 'a.png', pictures = { 'b.png' }, field = 'speed' }",
            "field cannot change pictures that exist"},
           {"contact_sheet { 'a.png', pictures = { 'b.png' }, times = { 0 } }",
            "times is given without recordings"},
       })
    EXPECT_THAT(refusal(bad.text), HasSubstr(bad.message)) << bad.text;
  EXPECT_FALSE(fs::exists(folder_.path / "a.png"));
  EXPECT_FALSE(fs::exists(folder_.path / "a.mp4"));
}

TEST_F(RecordingBindingTest, ARunThatGoesOnShowsWhatItHasSoFar) {
  console_.evaluate("s:record { 'now.h5', every = 1*us } s:run(1*us) r = recording 'now.h5'");
  EXPECT_EQ(value("#r.times"), "2");
  console_.evaluate("s:run(3*us) r:frame { 'a.png', width = 320 } later = recording 'now.h5'");
  EXPECT_EQ(value("#r.times < #later.times"), "true");
  console_.evaluate("s:close() r = recording 'now.h5' r:frame { 'a.png', width = 320 }");
  EXPECT_EQ(value("#r.times"), value("#later.times"));
}

TEST_F(RecordingBindingTest, ACheckedScriptWritesNothing) {
  ConsoleSettings settings = test::quiet(folder_.path);
  settings.purpose = Purpose::check;
  EXPECT_EQ(test::message_of("r = recording 'r.h5' r:frame 'c.png' r:movie 'c.mp4' show(r) "
                             "side_by_side { 'd.mp4', recordings = { r } } "
                             "contact_sheet { 'e.png', recordings = { r } }",
                             settings),
            "");
  for (const char* name : {"c.png", "c.mp4", "d.mp4", "e.png", "show_1.png"})
    EXPECT_FALSE(fs::exists(folder_.path / name)) << name;
  const auto failure = test::failure_of("recording 'later.h5'", settings);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind(), ErrorKind::script);  // the script uses results that do not exist yet
}

}  // namespace
}  // namespace hackle
