// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

// Returns the output of the script, run after the scene.
std::string printed(const std::string& script, ConsoleSettings settings) {
  testing::internal::CaptureStdout();
  const std::string message = test::message_of(test::scene + script, std::move(settings));
  std::string text = testing::internal::GetCapturedStdout();
  EXPECT_EQ(message, "");
  return text;
}

TEST(Show, WritesAPictureWhereThereIsNoTerminal) {
  const test::Folder folder;
  const std::string text =
      printed("show(s) show(s, { field = 'damage' })", test::quiet(folder.path));
  EXPECT_THAT(text, HasSubstr("damage at 0 s, 0 bonds broken: "));
  for (const char* name : {"show_1.png", "show_2.png"}) {
    EXPECT_THAT(text, HasSubstr((folder.path / name).string()));
    EXPECT_TRUE(fs::is_regular_file(folder.path / name));
  }
}

TEST(Show, LeavesStdoutToOthersWhenAskedTo) {
  const test::Folder folder;
  ConsoleSettings settings = test::quiet(folder.path);
  settings.print_to_stderr = true;
  EXPECT_EQ(printed("show(s)", settings), "");
  EXPECT_TRUE(fs::is_regular_file(folder.path / "show_1.png"));
}

TEST(Show, DrawsInTheTerminal) {
  const test::Folder folder;
  ConsoleSettings settings = test::quiet(folder.path);
  settings.show_in_terminal = true;
  const std::string text =
      printed("show(s) print '----' show(s, { zoom = {60*mm, 20*mm, 10*mm} })", settings);
  EXPECT_THAT(text, HasSubstr("\ndamage at 0 s, 0 bonds broken\n----\n"));
  EXPECT_THAT(text, HasSubstr("\ndamage at 0 s, 0 bonds broken, 20 mm wide\n"));
  EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(Show, TakesTheSimulationInBracesToo) {
  const test::Folder folder;
  const std::string text = printed(
      "local given = { s, zoom = {60*mm, 20*mm, 10*mm} } show(given) assert(given[1] == s) "
      "show { s } show(s, nil)",
      test::quiet(folder.path));
  EXPECT_THAT(text, HasSubstr("20 mm wide"));
  EXPECT_TRUE(fs::exists(folder.path / "show_3.png"));
}

TEST(Show, CanBeCalledBetweenTwoSteps) {
  const test::Folder folder;
  printed("s:on { 'every', every = 1*us, call = function() show(s) end } s:run(2*us)",
          test::quiet(folder.path));
  EXPECT_TRUE(fs::exists(folder.path / "show_1.png"));
  EXPECT_TRUE(fs::exists(folder.path / "show_2.png"));
}

TEST(Show, RefusesBadInput) {
  struct Bad {
    const char* call;
    const char* message;
  };
  for (const Bad& bad : {
           Bad{"show()", "show: expected a simulation first, got nothing"},
           {"show(p)", "show: expected a simulation first, got a plate"},
           {"show(5)", "show: expected a simulation first, got 5"},
           {"show {}", "show: expected a simulation first, got nothing"},
           {"show { p }", "show: expected a simulation first, got a plate"},
           {"show { zoom = {1, 1, 1} }", "show: expected a simulation first, got nothing"},
           {"show(s, 5)", "show: expected options in braces, got 5"},
           {"show(s, { s })", "stands in the braces without a name"},
           {"show { s, 5 }", "stands in the braces without a name"},
           {"show(s, { field = 'damge' })", "did you mean 'damage'"},
           {"show(s, { zoon = {1, 1, 1} })", "did you mean 'zoom'"},
           {"show(s, { zoom = 5 })", "show: zoom is 5, expected {x, y, half}"},
           {"show(s, { zoom = {1, 1} })", "show: zoom is not three finite numbers"},
           {"show(s, { zoom = {1, 1, 1, 1} })", "show: zoom is not three finite numbers"},
           {"show(s, { zoom = {0/0, 0, 1} })", "show: zoom is not three finite numbers"},
           {"show(s, { zoom = {0, 0, 1/0} })", "show: zoom is not three finite numbers"},
           {"show(s, { zoom = {0, 0, 0} })", "half the width of zoom is 0 m, it must be above 0 m"},
           {"show(s, { zoom = {0, 0, 1*mm} })", "it must lie between 2 mm and 1 m"},
           {"show(s, { zoom = {0, 0, -1*mm} })", "half the width of zoom is -1 mm"},
           {"show(s, { zoom = {0, 0, 2} })", "half the width of zoom is 2 m"},
           {"show(s, { zoom = {120*mm, 20*mm, 10*mm} })", "zoom shows nothing of the plate"},
           {"show { s, zoom = {50*mm, -40*mm, 10*mm} }", "the plate reaches from {0 m, 0 m}"},
           {"s:frame { 'a.png', zoom = {1, 1, 1*mm} }", "frame: half the width of zoom is 1 mm"},
           {"s:movie { 'a.mp4', every = 1*us, zoom = {1, 1, 9*mm} }", "movie: zoom shows nothing"},
       }) {
    const test::Folder folder;
    const std::string message = test::message_of(test::scene + bad.call, test::quiet(folder.path));
    EXPECT_THAT(message, HasSubstr(bad.message)) << bad.call;
    EXPECT_TRUE(fs::is_empty(folder.path)) << bad.call;
  }
}

TEST(Show, FramesAndMoviesZoomToo) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::scene + R"(
    local zoom = { 60*mm, 20*mm, 10*mm }
    s:movie { "a.mp4", every = 1*us, zoom = zoom, width = 320 }
    s:run(2*us)
    s:frame { "a.png", zoom = zoom, width = 320 }
  )",
                             test::quiet(folder.path)),
            "");
  EXPECT_TRUE(fs::is_regular_file(folder.path / "a.mp4"));
  EXPECT_TRUE(fs::is_regular_file(folder.path / "a.png"));
}

}  // namespace
}  // namespace hackle
