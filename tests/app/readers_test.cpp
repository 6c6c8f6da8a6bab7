// SPDX-License-Identifier: MIT
// Programs of other people read our files: h5py, h5dump and Python's csv.
#include <cstdlib>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "app/program.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "support/skipping.hpp"

namespace hackle {
namespace {

// The records by h5py against what hackle export writes of them, the series in the run file against
// its CSV.
const char* const compare = R"py(
import csv, h5py, math
run = h5py.File("a.h5", "r")
rows = list(csv.reader(open("a.csv")))
head, rows = rows[0], [[float(cell) for cell in row] for row in rows[1:]]
column = {name: [row[k] for row in rows] for k, name in enumerate(head)}
record = run["records/0/00003"]
def same(name, ours, theirs):
    for a, b in zip(ours, theirs, strict=True):
        assert math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-12), (name, a, b)
same("x", column["x (m)"], run["nodes"][:, 0])
same("damage", column["damage"], record["damage"][:])
same("uy", column["displacement_y (m)"], record["displacement"][:, 1])
assert max(column["damage"]) > 0 and max(column["displacement_y (m)"]) > 0
series = {name: data[:] for name, data in run["series/s"].items()}
table = list(csv.DictReader(open("s.csv")))
assert set(series) == set(table[0]), (set(series), table[0])
for name, values in series.items():
    same(name, [float(row[name]) for row in table], values)
print("same", len(table))
)py";

class Readers : public testing::Test {
 protected:
  int said(const std::string& command) const {
    return std::system(
        fmt::format("cd {} && {} > said 2>&1", shell_word(folder_.path.string()), command).c_str());
  }
  std::string text() const { return read_text(folder_.path / "said"); }

  test::Folder folder_;
  test::Program program_{folder_};
};

TEST_F(Readers, OfHdf5AndCsvSeeWhatWeSee) {
  HACKLE_NEEDS(said("/usr/bin/python3 -c 'import h5py'") == 0, "python3-h5py is not installed");
  HACKLE_NEEDS(said("h5dump --version") == 0, "hdf5-tools is not installed");
  write_text(folder_.path / "a.lua", test::scene + R"(
    s:record { 'a.h5', every = 1*us }
    s:log { 's.csv', every = 0.5*us, 'kinetic', 'bonds' }
    s:run(4*us))");
  ASSERT_EQ(program_.run({"run", "a.lua", "-o", ".", "-q"}).code, 0);
  ASSERT_EQ(program_.run({"export", "a.h5", "--csv", "--time", "3us", "-q"}).code, 0);
  write_text(folder_.path / "compare.py", compare);
  EXPECT_EQ(said("/usr/bin/python3 compare.py"), 0) << text();
  EXPECT_THAT(text(), testing::StartsWith("same"));
  EXPECT_EQ(said("h5dump -d /records/0/00003/damage a.h5"), 0) << text();
  EXPECT_THAT(text(), testing::HasSubstr("H5T_IEEE_F32LE"));
}

}  // namespace
}  // namespace hackle
