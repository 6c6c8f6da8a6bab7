// SPDX-License-Identifier: MIT
#include "app/command_chart.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "app/program.hpp"
#include "base/error.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

TEST(ChartJob, TellsSourcesKindsAndThePictureApart) {
  const ChartJob job = chart_job({"a.h5", "tip.x", "b.csv", "tip.y", "x.pdf", "paper=85mm"});
  EXPECT_THAT(job.sources, ElementsAre("a.h5", "b.csv"));
  EXPECT_THAT(job.what, ElementsAre("tip.x", "tip.y"));
  EXPECT_EQ(job.out, "x.pdf");
  EXPECT_THAT(job.options, ElementsAre(Pair("paper", "85mm")));
  EXPECT_EQ(chart_job({"out/a.h5", "tip.x"}).out, "a-tip_x.png");
  EXPECT_THAT(chart_job({"a.h5", "x.png"}).what, ElementsAre("energy"));
  EXPECT_TRUE(chart_job({"a.h5"}).what.empty());
}

TEST(ChartJob, NeedsASourceAndOnePicture) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{}, {"energy"}, {"a.h5", "a.png", "b.png"}, {"a.h5", "x=tip.x"}})
    try {
      chart_job(words);
      FAIL() << words.size();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
}

TEST(HackleChart, DrawsATableAndListsWhatItHolds) {
  const test::Folder folder;
  const test::Program program(folder);
  std::ofstream(folder.path / "run.csv")
      << "time_s,tip_x_m,tip_speed_m_per_s\n0,0.01,0\n1e-06,0.02,900\n";
  const test::Ended list = program.run({"chart", "run.csv"});
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_THAT(list.out, HasSubstr("tip_x, tip_speed"));
  const test::Ended drawn = program.run({"chart", "run.csv", "tip.x", "t.png", "width=640"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(fs::exists(folder.path / "t.png"));
  EXPECT_TRUE(fs::exists(folder.path / "t.chart.csv"));
  const test::Ended wrong = program.run({"chart", "run.csv", "tip.x", "them=dark"});
  EXPECT_NE(wrong.code, 0);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean 'theme'"));
}

}  // namespace
}  // namespace hackle
