// SPDX-License-Identifier: MIT
#include "store/run_series.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <hdf5.h>

#include "base/error.hpp"
#include "store/hdf5.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

// A file with a group "series/TABLE" that `fill` fills.
fs::path file_with(const fs::path& folder, const std::function<void(hid_t)>& fill) {
  const fs::path path = folder / "series.h5";
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t series = H5Gcreate2(file, "series", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t table = H5Gcreate2(series, "run", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  fill(table);
  H5Gclose(table);
  H5Gclose(series);
  H5Fclose(file);
  return path;
}

void add_column(hid_t group, const char* name, const std::vector<double>& values) {
  const hsize_t rows = values.size();
  const hid_t space = H5Screate_simple(1, &rows, nullptr);
  const hid_t column =
      H5Dcreate2(group, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(column, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(column);
  H5Sclose(space);
}

TEST(RunSeries, TablesAreReadBack) {
  const test::Folder folder;
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const auto path = file_with(folder.path, [&](hid_t table) {
    add_column(table, "time_s", {0.0, 1e-6});
    add_column(table, "tip_x_m", {nothing, 0.05});
  });
  const std::vector<SeriesTable> tables = series_in(path);
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].name, "run");
  EXPECT_EQ(tables[0].headings, (std::vector<std::string>{"time_s", "tip_x_m"}));
  EXPECT_EQ(tables[0].columns[0], (std::vector<double>{0.0, 1e-6}));
  EXPECT_TRUE(std::isnan(tables[0].columns[1][0]));
  EXPECT_EQ(tables[0].columns[1][1], 0.05);
}

// Names go into messages and charts, so those of a stranger's file are not believed.
TEST(RunSeries, RefusesWhatWeDoNotWrite) {
  const test::Folder folder;
  for (const std::function<void(hid_t)>& fill : std::vector<std::function<void(hid_t)>>{
           [](hid_t table) { add_column(table, "a b\x1b[31m", {1.0}); },
           [](hid_t table) {
             add_column(table, "time_s", {0.0, 1.0});
             add_column(table, "x_m", {0.0});
           },
           [](hid_t table) {
             H5Gclose(H5Gcreate2(table, "time_s", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
           }}) {
    const auto path = file_with(folder.path, fill);
    try {
      series_in(path);
      FAIL() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::files);
      EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\x1b")));
    }
  }
}

}  // namespace
}  // namespace hackle
