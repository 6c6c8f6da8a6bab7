// SPDX-License-Identifier: MIT
// A simulation and what it leaves behind: movies, pictures, run files, the summary.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/origin.hpp"
#include "base/progress.hpp"

namespace hackle {

class Observer;
class OutputNames;
class Simulation;
struct Execution;
struct Loads;
struct MovieOptions;
struct Numerics;
struct PictureOptions;
struct Plate;
struct QuasistaticResult;
struct RecordOptions;
struct Rehearsal;
struct RelaxResult;
struct Summary;

inline constexpr double default_output_limit = 20e9;  // bytes

class Run {
 public:
  // Throws what Simulation throws.
  Run(Plate plate, Numerics numerics, Execution execution, Talk talk, Origin origin);
  ~Run();

  // Each adds an output. Throws Error (refused) for impossible options and Error (files) when
  // `path` cannot be written. Nothing is written before the first step, except by frame().
  // The ending of the path says the kind of movie. Returns the path, or the one with the ending
  // that it falls back to. Throws Error (run_failed) when an encoder is missing.
  std::filesystem::path movie(const std::filesystem::path& path, const MovieOptions& options);
  void record(const std::filesystem::path& path, const RecordOptions& options);
  // Writes a PNG of the state as it is now.
  void frame(const std::filesystem::path& path, const PictureOptions& options);

  // What this run and its forks write is written by nobody else who shares the names, and the
  // other way round. Before the first output.
  void share_names(std::shared_ptr<OutputNames> names);

  // Movies and records of this run and of its forks may grow to so many bytes, by the estimate of
  // Output::expected. Afterwards run(), step() and load_slowly() throw Error (refused) before they
  // begin when there would be more. Pictures are not counted.
  void limit_output(double bytes);

  // Other loads from now on; see Simulation::set_loads. Also between two steps of a run.
  void set_loads(Loads loads);

  // Looks on between the steps of every run from now on. It may change loads, write pictures and
  // stop the run, but not run it or close it.
  void watch(std::shared_ptr<Observer> watcher);
  // The run that is under way ends here, or, called by a watcher, after this step.
  void stop();

  // The same state under the same loads, to go another way; nothing is under way in it, and it
  // writes no files yet.
  std::shared_ptr<Run> fork() const;
  // Goes back, or over, to the state and the loads of another run of the same plate and lattice.
  // Throws Error (refused) for any other, and when a movie or a record is not complete.
  void rewind(const Run& other);

  void run(double duration);      // s; see Simulation::run; shows progress on stderr
  void step(std::int64_t count);  // exactly so many steps

  // run() bit by bit, beside other work: start() asks for `duration` seconds more, go_on() goes on
  // for about so many seconds of wall time. Each throws what run() throws; after an error, but not
  // after an interrupt, nothing is under way any more.
  void start(double duration);
  void go_on(double seconds);
  // Until it has arrived, showing progress, or until so many steps have been taken in all.
  void wait(std::optional<std::int64_t> steps = std::nullopt);
  // Whether it has been started and has not arrived; paused or not.
  bool under_way() const;
  // go_on() does nothing from now on until resume(); wait() resumes.
  void pause();
  void resume();
  bool paused() const;
  // The next run is interrupted after so many steps in all, as if by Ctrl-C.
  void interrupt_at(std::int64_t step);
  // The step after which Ctrl-C last interrupted it; asked once.
  std::optional<std::int64_t> take_interrupt();
  // See Simulation::relax and load_slowly; both show progress on stderr. Outputs see the state
  // after each increment, when they are due.
  RelaxResult relax(double tolerance);
  QuasistaticResult load_slowly(double duration, int increments, double tolerance);
  // Completes movies and run files. Also done after an interrupt or a failure, so that they stay
  // valid. Can be called more than once; afterwards only frame(), report() and reading are allowed.
  void close();

  // From now on nothing is computed and no file is written: what is asked for is checked, and runs
  // arrive at once, with the plate as it was. rehearsal() says what they would take.
  void rehearse();
  Rehearsal rehearsal() const;
  // The script looks at results.
  void look();
  // What the script does here cannot be judged in a rehearsal, as a half-sentence.
  void doubt(std::string why);

  // Says on stderr when the ledger does not close (see ledger_remark), once for every state; done
  // by close(), too.
  void judge();

  const Simulation& simulation() const;
  Summary summary() const;
  // What a person wants to know, several lines of text.
  std::string report() const;

 private:
  struct Parts;
  explicit Run(std::unique_ptr<Parts> parts);
  void check_open(const char* who) const;
  void check_arrived(const char* who) const;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
