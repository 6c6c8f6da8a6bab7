// SPDX-License-Identifier: MIT
// chart, s:chart and r:chart.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "console/scripts.hpp"
#include "store/series_file.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

const std::string pulled_slowly = R"(
p = plate { width = 20*mm, height = 10*mm, material = "duran50" }
p:clamp { edge = "bottom", depth = 2*mm, name = "foot" }
p:traction { edge = "top", stress = {0, 1*MPa} }
s = simulate(p, { spacing = 1*mm })
)";

TEST(ChartBinding, DrawsWhatWasNoted) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(pulled_slowly + R"(
    s:log { "run.csv", every = 0.5*us }
    s:record { "run.h5", every = 1*us }
    s:run(2*us)
    s:chart { "now.png", "load" }
    s:close()
    r = recording "run.h5"
    r:chart { "later.svg", "strain", "kinetic" }
    r:chart "energy.pdf"
    chart { "all.png", "foot.fy", of = { "run.csv", r, s, { name = "own", time_s = {0, 1}, ["foot_fy_N_per_m"] = {2, 3} } },
            names = { "a", "b", "c", "d" } }
  )",
                             test::quiet(folder.path)),
            "");
  for (const char* name : {"now.png", "later.svg", "energy.pdf", "all.png"})
    EXPECT_TRUE(std::filesystem::exists(folder.path / name)) << name;
  const SeriesTable run = read_series(folder.path / "run.csv");
  const SeriesTable later = read_series(folder.path / "later.chart.csv");
  EXPECT_EQ(later.headings,
            (std::vector<std::string>{"time_s", "strain_J_per_m", "kinetic_J_per_m"}));
  EXPECT_EQ(later.columns[0], run.columns[0]);  // finer than the records
  EXPECT_EQ(later.columns[2], run.columns[3]);
  const SeriesTable own = read_series(folder.path / "all.chart.csv");
  EXPECT_EQ(own.headings.back(), "d_N_per_m");
  EXPECT_EQ(own.columns.back()[1], 3.0);
}

TEST(ChartBinding, RefusesInTheWordsOfTheCall) {
  const auto told = [](const char* call) { return test::message_of(pulled_slowly + call); };
  EXPECT_THAT(told("s:chart { 'a.png', 'energy' }"), HasSubstr("s:log notes columns"));
  EXPECT_THAT(told("s:chart { 'a.jpg' }"), HasSubstr(".png"));
  EXPECT_THAT(told("chart { 'a.png' }"), HasSubstr("of is missing"));
  EXPECT_THAT(told("chart { 'a.png', of = { {} } }"), HasSubstr("is empty"));
  EXPECT_THAT(told("chart { 'a.png', of = { { x = {1}, y = {1, 2} } } }"),
              HasSubstr("different lengths"));
  EXPECT_THAT(told("chart { 'a.png', of = { { x = {1, 'a'} } } }"),
              HasSubstr("no list of numbers"));
  EXPECT_THAT(told("chart { 'a.png', of = { 5 } }"), HasSubstr("neither a file"));
  EXPECT_THAT(told("chart { 'a.png', of = { s }, names = { 'a', 'b' } }"),
              HasSubstr("2 names for 1"));
  EXPECT_THAT(told("s:log 'a.chart.csv' s:chart { 'a.png', 'histogram' }"),
              HasSubstr("a.chart.csv"));
}

// A chart may be drawn again: it shows what has been noted since.
TEST(ChartBinding, MayBeDrawnAgain) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(pulled_slowly + R"(
    s:log { "run.csv", every = 0.5*us }
    for _ = 1, 2 do s:run(1*us) s:chart { "energy.png" } end
  )",
                             test::quiet(folder.path)),
            "");
  EXPECT_EQ(read_series(folder.path / "energy.chart.csv").columns[0].size(), 5U);
}

TEST(ChartBinding, OnlyLooksAtAScriptThatIsChecked) {
  const test::Folder folder;
  ConsoleSettings settings = test::quiet(folder.path);
  settings.purpose = Purpose::check;
  EXPECT_EQ(test::message_of(pulled_slowly + R"(
    s:log "run.csv" s:run(1*us) s:chart { "energy.png" }
  )",
                             settings),
            "");
  EXPECT_FALSE(std::filesystem::exists(folder.path / "energy.png"));
}

}  // namespace
}  // namespace hackle
