// SPDX-License-Identifier: MIT
// A simulation with its output: movies, pictures, run files, the summary.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/origin.hpp"
#include "base/progress.hpp"

namespace hackle {

class Observer;
class OutputNames;
class Simulation;
struct Column;
struct Checkpoint;
struct CrackGraph;
struct ErrorBudget;
struct Execution;
struct Loads;
struct MovieOptions;
struct Numerics;
struct OutputMark;
struct PictureOptions;
struct Plate;
struct QuasistaticResult;
struct RecordOptions;
struct Rehearsal;
struct RelaxResult;
struct SeriesOptions;
struct SeriesTable;
struct Summary;
struct TimePoint;

inline constexpr double default_output_limit = 20e9;  // bytes

class Run {
 public:
  // Throws what Simulation throws.
  Run(Plate plate, Numerics numerics, Execution execution, Talk talk, Origin origin);
  // Goes on with a simulation that is there already, such as one from a checkpoint.
  Run(Simulation simulation, Talk talk, Origin origin);
  ~Run();

  // Each function adds an output. Throws Error (refused) for impossible options, Error (files) if
  // `path` cannot be written, and Error (run_failed) if an encoder is missing. Nothing is written
  // before the first step, except by frame(). The extension of the path determines the kind of
  // movie. Returns the path, or the one with the extension of the fallback.
  std::filesystem::path movie(const std::filesystem::path& path, const MovieOptions& options);
  void record(const std::filesystem::path& path, const RecordOptions& options);
  void log(const std::filesystem::path& path, const SeriesOptions& options,
           std::vector<Column> columns);
  // Returns the tables of log() so far, one for each file that has a row.
  std::vector<SeriesTable> tables() const;
  // Writes a PNG of the present state.
  void frame(const std::filesystem::path& path, const PictureOptions& options);

  // Writes the whole state, to go on from it later; also allowed between two steps of a run. See
  // write_checkpoint().
  void save(const std::filesystem::path& path);

  // From now on keeps the state every `seconds` of wall time while it runs, and when it ends early,
  // at places that `place` tells, with what `continuation` returns; see CheckpointKeeper. Outputs
  // added from now on can be continued.
  void keep_checkpoints(double seconds, std::function<std::filesystem::path()> place,
                        std::function<std::string()> continuation);
  // Keeps the present state, if checkpoints are kept; never throws.
  void keep_last();
  // Waits until the last checkpoint is written.
  void finish_checkpoints() const;
  // Returns how far the movies and records have come, and the files that only continuing them
  // needs.
  std::vector<OutputMark> marks() const;
  // Returns when the disk has all that the marks tell of.
  void settle();
  std::vector<std::filesystem::path> kept_files() const;

  // For replaying a script: claims to be at that point, and then takes the state of a checkpoint
  // with the loads as they are, and goes on with the outputs at their marks. Throws what
  // hackle::resume and Outputs::continue_from throw, and Error (refused) if the inputs are others
  // than those in the checkpoint.
  void pretend(const TimePoint& point);
  void restore(Checkpoint checkpoint);
  void continue_outputs(const std::vector<OutputMark>& marks);
  // Finishes a run() that had been started; then slow loading may go on likewise.
  void go_on_to_aim();

  // Shares the registry of file names, so that this run, its forks and other users of the registry
  // never write the same file. Call this before the first output.
  void share_names(std::shared_ptr<OutputNames> names);

  // Limits the total size of movies and records of this run and its forks, as estimated by
  // Output::expected. run(), step() and load_slowly() then throw Error (refused) before they begin
  // if it would be exceeded. Pictures are not counted.
  void limit_output(double bytes);

  // Exchanges the loads; see Simulation::set_loads. Also allowed between two steps of a run.
  void set_loads(Loads loads);

  // Adds an observer of every later run. It may change loads, write pictures and stop the run, but
  // not run or close it.
  void watch(std::shared_ptr<Observer> watcher);
  // The summary tells displacements at places of the plate at that time, s; see SampledField.
  void sample_at(double time);
  // What has chosen its numerics, for the report.
  void set_budget(const ErrorBudget& budget);
  // Ends the present run; from a watcher, after the current step.
  void stop();

  // Returns a run with the same state and loads, to be continued differently; it has no work in
  // progress and no outputs.
  std::shared_ptr<Run> fork() const;
  // Takes over the state and the loads of another run of the same plate and lattice. Throws Error
  // (refused) for any other, and if a movie or a record is not complete.
  void rewind(const Run& other);

  void run(double duration);      // s; see Simulation::run; shows progress on stderr
  void step(std::int64_t count);  // exactly this many steps

  // run() in small portions, beside other work: start() requests `duration` seconds more, go_on()
  // continues for about that many seconds of wall time. Each throws what run() throws; after an
  // error, but not after an interrupt, no work remains.
  void start(double duration);
  void go_on(double seconds);
  // Finishes the run, showing progress, or continues until this many steps have been taken in all.
  void wait(std::optional<std::int64_t> steps = std::nullopt);
  // Returns whether the run has been started and has not finished; it may be paused.
  bool under_way() const;
  // Makes go_on() do nothing until resume(); wait() resumes.
  void pause();
  void resume();
  bool paused() const;
  // Interrupts the next run after this many steps in all, as if by Ctrl-C.
  void interrupt_at(std::int64_t step);
  // Returns the step after which Ctrl-C last interrupted the run, and forgets it.
  std::optional<std::int64_t> take_interrupt();
  // See Simulation::relax and load_slowly; both show progress on stderr. Outputs see the state
  // after each increment, when they are due.
  RelaxResult relax(double tolerance);
  QuasistaticResult load_slowly(double duration, int increments, double tolerance);
  // Completes movies and run files. Also called after an interrupt or a failure, so that they stay
  // valid. May be called repeatedly; afterwards only frame(), report() and reading are allowed.
  void close();

  // From now on nothing is computed and no file is written: requests are checked, and runs end at
  // once with the plate unchanged. rehearsal() returns their expected cost.
  void rehearse();
  Rehearsal rehearsal() const;
  // Notes that the script reads results.
  void look();
  // Notes that an action of the script cannot be judged in a rehearsal, as a clause.
  void doubt(std::string why);

  // Reports on stderr if the ledger does not close (see ledger_remark), once per state; close()
  // also does this.
  void judge();

  const Simulation& simulation() const;
  Summary summary() const;
  // Returns the cracks as they are, from the bonds that broke in this run.
  CrackGraph crack_graph() const;
  // Returns the report, several lines of text.
  std::string report() const;

 private:
  struct Parts;
  class SlowNote;
  explicit Run(std::unique_ptr<Parts> parts);
  void check_open(const char* who) const;
  void check_arrived(const char* who) const;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
