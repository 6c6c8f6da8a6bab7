// SPDX-License-Identifier: MIT
#include "store/series_file.hpp"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using Row = std::vector<std::optional<double>>;

const std::vector<std::string> two_columns{"time_s", "tip_x_m"};

TEST(SeriesFile, NumbersComeBackToTheLastBitAndEmptyCellsAsNone) {
  const auto path = test::fresh_folder() / "new" / "a.csv";
  SeriesFile file(path, two_columns);
  file.add(Row{0.1, std::nullopt});
  file.add(Row{1.0 / 3.0, -4.9e-324});
  file.close();
  EXPECT_EQ(read_text(path), "time_s,tip_x_m\n0.1,\n0.3333333333333333,-5e-324\n");
  const SeriesTable table = read_series(path);
  EXPECT_EQ(table.name, "a");
  EXPECT_EQ(table.headings, two_columns);
  EXPECT_EQ(table.columns[0], (std::vector<double>{0.1, 1.0 / 3.0}));
  EXPECT_TRUE(std::isnan(table.columns[1][0]));
  EXPECT_EQ(table.columns[1][1], -4.9e-324);
}

// A run that was killed in the middle of a row goes on from a state at 2 s.
TEST(SeriesFile, GoesOnAfterTheLastRowThatIsKept) {
  const auto path = test::fresh_folder() / "a.csv";
  std::ofstream(path) << "time_s,tip_x_m\n1,10\n2,20\n3,30\n4,4";
  SeriesFile file = SeriesFile::reopened(path, two_columns, 2.0);
  file.add(Row{3.0, 31.0});
  file.close();
  EXPECT_EQ(read_text(path), "time_s,tip_x_m\n1,10\n2,20\n3,31\n");
  SeriesFile::reopened(path, two_columns, 99.0).close();
  EXPECT_EQ(read_text(path), "time_s,tip_x_m\n1,10\n2,20\n3,31\n");
}

TEST(SeriesFile, GoesOnAfterANumberOfRows) {
  const auto path = test::fresh_folder() / "a.csv";
  std::ofstream(path) << "time_s,tip_x_m\n1,10\n2,20\n3,30\n";
  SeriesFile::reopened(path, two_columns, 99.0, 2).close();
  EXPECT_EQ(read_text(path), "time_s,tip_x_m\n1,10\n2,20\n");
  EXPECT_THROW(SeriesFile::reopened(path, two_columns, 99.0, 3), Error);
}

TEST(SeriesFile, DoesNotGoOnInATableOfOtherColumns) {
  const auto path = test::fresh_folder() / "a.csv";
  std::ofstream(path) << "time_s,other\n1,10\n";
  EXPECT_THROW(SeriesFile::reopened(path, two_columns, 2.0), Error);
  EXPECT_EQ(read_text(path), "time_s,other\n1,10\n");
  EXPECT_THROW(SeriesFile::reopened(path.parent_path() / "none.csv", two_columns, 2.0), Error);
}

TEST(SeriesFile, ARowReachesTheFileBeforeItIsComplete) {
  const auto path = test::fresh_folder() / "a.csv";
  SeriesFile file(path, two_columns);
  file.add(Row{1.0, 2.0});
  file.flush();
  EXPECT_EQ(read_text(path), "time_s,tip_x_m\n1,2\n");
}

TEST(SeriesFile, HasOneWriter) {
  const auto path = test::fresh_folder() / "a.csv";
  const SeriesFile file(path, two_columns);
  EXPECT_THROW(SeriesFile(path, two_columns), Error);
}

TEST(SeriesFile, WhatIsNoTableIsRefused) {
  const auto path = test::fresh_folder() / "a.csv";
  const auto refusal = [&](const char* text) -> std::string {
    std::ofstream(path) << text;
    try {
      read_series(path);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  EXPECT_THAT(refusal(""), HasSubstr("no head line"));
  EXPECT_THAT(refusal("a,b\n1\n"), HasSubstr("row 1 has 1 cells, its head line 2"));
  EXPECT_THAT(refusal("a,b\n1,nan\n"), HasSubstr("row 1 holds something that is no number"));
  EXPECT_THAT(refusal("a,b\n1,2 \n"), HasSubstr("no number"));
}

}  // namespace
}  // namespace hackle
