// SPDX-License-Identifier: MIT
// The file of a killed run. A process can be killed between any two writes to its file: this test
// records the writes of the HDF5 library and rebuilds the file write by write.
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "store/run_file.hpp"
#include "store/xdmf.hpp"
#include "support/folder.hpp"
#include "support/run_file_reader.hpp"
#include "support/scenes.hpp"

namespace {

struct Write {
  off_t at = 0;
  std::vector<char> bytes;
  bool truncates = false;
};

// The list that the functions below append to; null when they record nothing.
std::vector<Write>* noted = nullptr;

ssize_t note_and_write(int file, const void* bytes, size_t count, off_t at) {
  if (noted != nullptr) {
    const char* begin = static_cast<const char*>(bytes);
    noted->push_back({at, {begin, begin + count}});
  }
  return syscall(SYS_pwrite64, file, bytes, count, at);
}

int note_and_truncate(int file, off_t size) {
  if (noted != nullptr) noted->push_back({size, {}, true});
  return static_cast<int>(syscall(SYS_ftruncate, file, size));
}

}  // namespace

// These replace the C library's functions, under every name that the HDF5 library may use.
extern "C" {
ssize_t pwrite(int file, const void* bytes, size_t count, off_t at) {
  return note_and_write(file, bytes, count, at);
}
ssize_t pwrite64(int file, const void* bytes, size_t count, off_t at) {
  return note_and_write(file, bytes, count, at);
}
int ftruncate(int file, off_t size) noexcept {
  return note_and_truncate(file, size);
}
int ftruncate64(int file, off_t size) noexcept {
  return note_and_truncate(file, size);
}
}

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::RunFileReader;

constexpr int records = 12;

std::vector<Write> writes_of_a_run(const fs::path& path) {
  Plate plate = test::bare_plate(20, 10);
  plate.loads.tractions.push_back({Edge::top, {0.0, 5e6}});
  Simulation simulation(plate, test::numerics(), {1});
  std::vector<Write> writes;
  noted = &writes;
  {
    RunFile file(path, simulation, {"a.lua", "-- the script"});
    for (int record = 0; record < records; ++record) {
      file.add(simulation);
      simulation.step();
    }
  }
  noted = nullptr;
  return writes;
}

void apply(const Write& write, int file) {
  if (write.truncates) {
    ASSERT_EQ(syscall(SYS_ftruncate, file, write.at), 0);
  } else {
    ASSERT_EQ(syscall(SYS_pwrite64, file, write.bytes.data(), write.bytes.size(), write.at),
              static_cast<long>(write.bytes.size()));
  }
}

// Returns whether every committed record of `partly` equals that of `whole`.
bool committed_are_whole(const RunFileReader& partly, const RunFileReader& whole) {
  const auto count = static_cast<std::size_t>(partly.committed());
  const std::vector<double> times = partly.numbers("time"), all_times = whole.numbers("time");
  if (times.size() < count || !std::equal(times.begin(), times.begin() + count, all_times.begin()))
    return false;
  for (std::size_t record = 0; record < count; ++record)
    for (const char* field : {"/damage", "/displacement", "/velocity", "/broken"}) {
      const std::string name = record_group(record) + field;
      if (partly.numbers(name) != whole.numbers(name)) return false;
    }
  return true;
}

// Another program goes on behind the committed records, whatever else the killed one has left.
void expect_gone_on_with(const fs::path& partly, long long records, const RunFileReader& whole) {
  const fs::path path = partly.parent_path() / "gone_on_with.h5";
  fs::copy_file(partly, path, fs::copy_options::overwrite_existing);
  const Lattice lattice(test::bare_plate(20, 10), test::numerics());
  RunFile(path, lattice.grid, standard_contents(lattice.grid), records).finish();
  const RunFileReader copy(path);
  EXPECT_EQ(copy.committed(), records);
  EXPECT_EQ(copy.numbers("step").size(), static_cast<std::size_t>(records));
  EXPECT_TRUE(committed_are_whole(copy, whole));
}

TEST(AKilledRun, LeavesEveryCommittedRecordWhateverTheMoment) {
  const fs::path folder = test::fresh_folder();
  const std::vector<Write> writes = writes_of_a_run(folder / "whole.h5");
  ASSERT_GT(writes.size(), 5U * records);  // otherwise the functions above were not called
  const RunFileReader whole(folder / "whole.h5");
  const fs::path path = folder / "partly.h5";
  const int file = open(path.c_str(), O_WRONLY | O_CREAT, 0600);
  long long max_committed = -1;
  for (std::size_t k = 0; k < writes.size(); ++k) {
    apply(writes[k], file);
    const RunFileReader partly(path);
    // Before the constructor of RunFile has returned, the file does not count.
    const bool complete = partly.opens() && partly.holds("records");
    if (!complete) {
      ASSERT_EQ(max_committed, -1) << "write " << k << " of " << writes.size();
      continue;
    }
    ASSERT_GE(partly.committed(), max_committed);
    max_committed = partly.committed();
    ASSERT_TRUE(committed_are_whole(partly, whole)) << "write " << k << " of " << writes.size();
    if (max_committed > 0 && k % 23 == 0) expect_gone_on_with(path, max_committed, whole);
  }
  close(file);
  EXPECT_EQ(max_committed, records);
}

}  // namespace
}  // namespace hackle
