// SPDX-License-Identifier: MIT
// Run files that another program goes on with: they hold the records of a run that was never
// stopped.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "output/files/output_names.hpp"
#include "output/files/record_output.hpp"
#include "output/report/summary.hpp"
#include "solver/simulation.hpp"
#include "store/recording.hpp"
#include "store/xdmf.hpp"
#include "support/folder.hpp"
#include "support/run_file_reader.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::RunFileReader;
using testing::HasSubstr;

constexpr int recorded_steps = 8;  // a record at the start and one after each

const Simulation& cracked_plate() {
  static const Simulation simulation = [] {
    Plate plate = test::bare_plate(20, 12);
    plate.cracks.push_back({{0.0, 0.003}, {0.005, 0.003}, Born::broken});
    plate.loads.tractions.push_back({Edge::top, {1e6, 4e8}});
    return Simulation(plate, test::numerics(), {1});
  }();
  return simulation;
}

std::unique_ptr<RecordOutput> record_at(const fs::path& path) {
  RecordOptions options;
  options.every = cracked_plate().dt();
  auto record = std::make_unique<RecordOutput>(path, options, cracked_plate(),
                                               Origin{"a.lua", "-- the script"}, Talk::quiet,
                                               std::make_shared<OutputNames>());
  record->keep_continuable();
  return record;
}

// Tells the journal of something that is done in the middle.
void record_run(RecordOutput& record, Simulation& simulation, int steps) {
  const std::array<Observer*, 1> observers{&record};
  for (int k = 0; k < std::max(steps, 1); ++k) {
    simulation.run(std::min(steps, 1) * simulation.dt(), observers);
    if (simulation.state().step == recorded_steps / 2) record.journal()->changed_loads(simulation);
  }
}

struct KilledRecord {
  Simulation simulation;
  OutputMark mark;
};

// Leaves the files of a program that was killed `more` steps after the checkpoint at `steps`.
KilledRecord recorded_and_killed(const fs::path& folder, int steps, int more) {
  fs::create_directories(folder / "own");
  fs::create_directories(folder / "copy");
  Simulation simulation = cracked_plate();
  const auto record = record_at(folder / "own" / "a.h5");
  if (steps >= 0) record_run(*record, simulation, steps);
  KilledRecord recorded{simulation, record->mark()};
  record->settled()();
  if (more > 0) record_run(*record, simulation, more);
  fs::copy(folder / "own", folder / "copy", fs::copy_options::recursive);
  return recorded;
}

void go_on_recording(const fs::path& path, KilledRecord& recorded) {
  const auto record = record_at(path);
  record->continue_from(recorded.mark);
  const auto done = static_cast<int>(recorded.simulation.state().step);
  if (recorded.mark.pieces > 0) {
    EXPECT_EQ(Recording(path).times().size(), static_cast<std::size_t>(recorded.mark.pieces));
    EXPECT_EQ(RunFileReader(path).attribute("/", "script_name"), "a.lua");
  }
  record_run(*record, recorded.simulation, recorded_steps - done);
  record->close();
  EXPECT_EQ(record->files(), (std::vector{path, sidecar_of(path)}));
}

void expect_equal_contents(const fs::path& path, const fs::path& uncut) {
  const RunFileReader one(path), other(uncut);
  ASSERT_TRUE(one.opens());
  EXPECT_EQ(one.committed(), recorded_steps + 1);
  for (const char* name : {"time", "step", "nodes"})
    EXPECT_EQ(one.numbers(name), other.numbers(name)) << name;
  const std::string journal = record_group(recorded_steps / 2 + 1) + "/journal";
  for (const std::string& name : {std::string("script"), std::string("inputs"), journal})
    EXPECT_EQ(one.text(name), other.text(name));
  EXPECT_THAT(other.text(journal), HasSubstr("loads"));
  for (std::size_t k = 0; k <= recorded_steps; ++k)
    for (const char* field : {"/damage", "/displacement", "/velocity", "/broken"}) {
      const std::string name = record_group(k) + field;
      ASSERT_FALSE(other.numbers(name).empty());
      EXPECT_EQ(one.numbers(name), other.numbers(name)) << name;
    }
}

void expect_same_records(const fs::path& path, const fs::path& uncut) {
  expect_equal_contents(path, uncut);
  EXPECT_EQ(read_text(sidecar_of(path)), read_text(sidecar_of(uncut)));
  const Recording opened(path);
  EXPECT_EQ(opened.times().size(), recorded_steps + 1U);
}

fs::path recorded_uncut(const test::Folder& folder) {
  fs::create_directories(folder.path / "uncut");
  const fs::path path = folder.path / "uncut" / "a.h5";
  Simulation simulation = cracked_plate();
  const auto record = record_at(path);
  record_run(*record, simulation, recorded_steps);
  record->close();
  return path;
}

TEST(AContinuedRecord, HasTheRecordsOfTheUncutRun) {
  const test::Folder folder;
  const fs::path uncut = recorded_uncut(folder);
  for (const auto& [steps, more] : std::vector<std::pair<int, int>>{
           {-1, 2}, {0, 0}, {0, 3}, {4, 0}, {4, 3}, {recorded_steps, 0}}) {
    const fs::path here = folder.path / fmt::format("{} {}", steps, more);
    KilledRecord recorded = recorded_and_killed(here, steps, more);
    EXPECT_EQ(recorded.mark.pieces, steps + 1);
    go_on_recording(here / "copy" / "a.h5", recorded);
    expect_same_records(here / "copy" / "a.h5", uncut);
    int files = 0;  // the run file and its sidecar: nothing cut off, nothing partial
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(here / "copy")) ++files;
    EXPECT_EQ(files, 2) << steps << " " << more;
  }
}

TEST(AContinuedRecord, MayHaveBeenCompletedAndContinuedBefore) {
  const test::Folder folder;
  const fs::path uncut = recorded_uncut(folder);
  KilledRecord recorded = recorded_and_killed(folder.path, 2, 1);
  const fs::path path = folder.path / "copy" / "a.h5";
  {
    const auto record = record_at(path);
    record->continue_from(recorded.mark);
    record_run(*record, recorded.simulation, 3);
    recorded.mark = record->mark();
    EXPECT_EQ(recorded.mark.pieces, 6);
    record->close();  // as at Ctrl-C
  }
  go_on_recording(path, recorded);
  expect_same_records(path, uncut);
}

TEST(AContinuedRecord, ThatWasCompleteIsNotTouched) {
  const test::Folder folder;
  const fs::path path = recorded_uncut(folder);
  const std::string before = read_text(path);
  const auto record = record_at(path);
  record->continue_from({path, recorded_steps + 1, 0.0, recorded_steps + 1, true});
  record->reserve();
  EXPECT_EQ(record->files(), (std::vector{path, sidecar_of(path)}));
  EXPECT_TRUE(record->mark().complete);
  record->close();
  EXPECT_EQ(read_text(path), before);
}

std::string refusal_to_record_on(const fs::path& path, const OutputMark& mark) {
  try {
    record_at(path)->continue_from(mark);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    return error.what();
  }
}

TEST(AContinuedRecord, NeedsItsRunFile) {
  const test::Folder folder;
  const KilledRecord recorded = recorded_and_killed(folder.path, 4, 0);
  const fs::path path = folder.path / "copy" / "a.h5";
  OutputMark later = recorded.mark;
  later.pieces = 7;
  const std::string before = read_text(path);
  EXPECT_THAT(refusal_to_record_on(path, later),
              testing::AllOf(HasSubstr("it has 5 records, the run to go on with had 7"),
                             HasSubstr("--fresh")));
  EXPECT_EQ(read_text(path), before);
  fs::resize_file(path, 3000);
  EXPECT_THAT(refusal_to_record_on(path, recorded.mark), HasSubstr(path.string()));
  write_text(path, "no run file");
  EXPECT_THAT(refusal_to_record_on(path, recorded.mark), HasSubstr(path.string()));
  fs::remove(path);
  EXPECT_THAT(refusal_to_record_on(path, recorded.mark), HasSubstr(path.string()));
  EXPECT_FALSE(fs::exists(partial_name(path)));
}

TEST(AContinuedRecord, IsNotTakenFromWhoStillRecordsIt) {
  const test::Folder folder;
  Simulation simulation = cracked_plate();
  const auto record = record_at(folder.path / "a.h5");
  record_run(*record, simulation, 2);
  EXPECT_THAT(refusal_to_record_on(folder.path / "a.h5", record->mark()),
              HasSubstr("is being written by another run"));
}

}  // namespace
}  // namespace hackle
