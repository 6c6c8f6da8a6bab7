// SPDX-License-Identifier: MIT
// A run file while it is written, and after its program was killed.
#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "store/recording.hpp"
#include "store/run_file.hpp"
#include "store/run_rescue.hpp"
#include "store/xdmf.hpp"
#include "support/folder.hpp"
#include "support/run_file_reader.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::RunFileReader;
using testing::HasSubstr;

Simulation loaded_plate() {
  Plate plate = test::bare_plate(30, 20);
  plate.loads.tractions.push_back({Edge::top, {1e6, 5e6}});
  return Simulation(plate, test::numerics(), {1});
}

// Returns the number of committed records; -1 if the file does not open.
long long committed_records(const fs::path& path) {
  const RunFileReader reader(path);
  return reader.opens() ? reader.committed() : -1;
}

// Returns the number of whole records. Each record has its own number as time; -1 if committed data
// are missing. Counted through a separate opening: the library determines the end of a file on
// opening, and does not see data committed after that.
long long whole_records(const fs::path& path) {
  const long long count = committed_records(path);
  const RunFileReader reader(path);
  if (!reader.opens()) return -1;
  const std::vector<double> steps = reader.numbers("step");
  if (count < 0 || steps.size() < static_cast<std::size_t>(count)) return -1;
  for (long long k = 0; k < count; ++k) {
    if (steps[static_cast<std::size_t>(k)] != static_cast<double>(k)) return -1;
    const std::string group = record_group(static_cast<std::size_t>(k));
    if (reader.numbers(group + "/velocity").size() != 1800) return -1;
    if (reader.numbers(group + "/damage").size() != 600) return -1;
  }
  return count;
}

// Does the same for readers that are stopped while the writer continues: such a reading fails by a
// checksum or a length, and the next one does not.
long long whole_records_soon(const fs::path& path) {
  constexpr int max_trials = 20;
  long long count = -1;
  for (int trial = 0; trial < max_trials && count < 0; ++trial) count = whole_records(path);
  return count;
}

TEST(ARunFileBeingWritten, IsReadByOthersAtAnyMoment) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.h5";
  constexpr int records = 120;
  const pid_t writer = fork();
  ASSERT_GE(writer, 0);
  if (writer == 0) {
    Simulation simulation = loaded_plate();
    RunFile file(path, simulation, {});
    for (int k = 0; k < records; ++k) {
      file.add(simulation);
      simulation.step();
    }
    file.finish();
    _exit(0);
  }
  int readings = 0, different = 0, status = 0;
  long long last = 0;
  while (waitpid(writer, &status, WNOHANG) == 0) {
    if (!fs::exists(path.string() + "") || !RunFileReader(path).opens()) continue;  // not begun
    if (!RunFileReader(path).holds("records")) continue;
    const long long count = whole_records_soon(path);
    ASSERT_GE(count, last) << "reading " << readings;
    if (count > last) ++different;
    last = count;
    ++readings;
  }
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_GT(different, 2) << readings << " readings";
  EXPECT_EQ(whole_records(path), records);
}

TEST(ARunFileBeingWritten, IsARecordingOfWhatIsThere) {
  const test::Folder folder;
  Simulation simulation = loaded_plate();
  RunFile file(folder.path / "a.h5", simulation, {});
  file.add(simulation);
  simulation.step();
  file.add(simulation);
  EXPECT_EQ(Recording(folder.path / "a.h5").times().size(), 2U);
  simulation.step();
  file.add(simulation);  // as before
  file.finish();
  EXPECT_EQ(Recording(folder.path / "a.h5").times().size(), 3U);
}

// Runs a program that is killed after this many records.
void record_and_die(const fs::path& path, int records) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Simulation simulation = loaded_plate();
    RunFile file(path, simulation, {});
    for (int k = 0; k < records; ++k) {
      file.add(simulation);
      simulation.step();
    }
    std::raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

TEST(ARunThatWasKilled, IsKeptWithASidecarOfItsOwn) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.h5";
  record_and_die(path, 7);
  const auto rescued = rescue_run(path);
  ASSERT_TRUE(rescued);
  EXPECT_EQ(rescued->file, folder.path / "a.cut_off.h5");
  EXPECT_EQ(rescued->records, 7);
  EXPECT_FALSE(fs::exists(path));
  EXPECT_EQ(Recording(rescued->file).times().size(), 7U);
  const std::string sidecar = read_text(folder.path / "a.cut_off.xdmf");
  for (int k = 0; k < 7; ++k)
    EXPECT_THAT(sidecar,
                HasSubstr(">a.cut_off.h5:/records/0/0000" + std::to_string(k) + "/damage<"));
  EXPECT_FALSE(rescue_run(path));
}

TEST(ARunThatWasKilled, DoesNotTakeANameThatIsThereOrGoingToBe) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.h5";
  write_text(folder.path / "a.cut_off.h5", "of an earlier one");
  write_text(folder.path / "a.cut_off_2.xdmf", "of another");
  record_and_die(path, 1);
  const auto rescued = rescue_run(
      path, [&](const fs::path& name) { return name == folder.path / "a.cut_off_3.h5"; });
  ASSERT_TRUE(rescued);
  EXPECT_EQ(rescued->file.filename(), "a.cut_off_4.h5");
}

TEST(ARunThatWasKilled, IsNothingToKeepWhereNothingWasRecorded) {
  const test::Folder folder;
  const fs::path path = folder.path / "a.h5";
  EXPECT_FALSE(rescue_run(path));
  record_and_die(path, 0);
  EXPECT_FALSE(rescue_run(path));
  write_text(path, "no run file");
  EXPECT_FALSE(rescue_run(path));
  Simulation simulation = loaded_plate();
  {
    RunFile file(path, simulation, {});
    file.add(simulation);
    file.finish();  // complete: it may be replaced
  }
  EXPECT_FALSE(rescue_run(path));
  EXPECT_TRUE(fs::exists(path));
}

TEST(ARunFile, OfANameThatParaViewCannotFollowIsRefused) {
  for (const char* name : {"a:b.h5", "a|b.h5", "a\nb.h5", "a\tb.h5", "gl\xe4s.h5", " a.h5", "a .h5",
                           "\xc0\x80.h5", "\xed\xa0\x80.h5"})
    EXPECT_THROW(check_name(fs::path("out") / name), Error) << name;
  for (const char* name : {"a b.h5", "a&b<c>'\"#%?;,=+@!~$.h5", "gl\xc3\xa4s.h5", "\xe2\x82\xac.h5",
                           "\xf0\x9f\x98\x80.h5", "a.b.hdf5"})
    EXPECT_NO_THROW(check_name(fs::path("o:ut") / name)) << name;
}

}  // namespace
}  // namespace hackle
