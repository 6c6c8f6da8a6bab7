// SPDX-License-Identifier: MIT
// The state shared by the functions of a script: how it was called, and the simulations it made.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/image.hpp"
#include "base/progress.hpp"
#include "console/language/materials.hpp"
#include "console/language/plate_memory.hpp"
#include "console/lua/lua_memory.hpp"
#include "console/lua/sandbox.hpp"
#include "console/prompt/idle.hpp"
#include "console/prompt/transcript.hpp"
#include "console/replay/call_watch.hpp"
#include "console/replay/script_checkpoints.hpp"
#include "output/files/output_folder.hpp"
#include "output/files/output_names.hpp"
#include "output/report/expectation.hpp"
#include "output/report/summary.hpp"
#include "output/run/rehearsal.hpp"
#include "output/run/run.hpp"
#include "solver/simulation.hpp"
#include "store/recording.hpp"

struct lua_State;

namespace hackle {

// The purpose of running a script: its results, a check of its validity and cost, or a list of its
// options.
enum class Purpose { results, check, options };

struct ConsoleSettings {
  Purpose purpose = Purpose::results;
  std::filesystem::path output_folder;           // "": out/<name of the script>
  bool force = false;                            // what is in it may be overwritten
  bool fresh = false;                            // an unfinished run is not continued
  double checkpoint_every = 600.0;               // s of wall time; 0: none
  std::map<std::string, std::string> overrides;  // --set key=value
  Execution execution;
  Talk talk = Talk::plain;
  // Shows a long text to a person; empty: it is printed.
  std::function<void(const std::string&)> page;
  bool print_to_stderr = false;   // output of the script: stdout serves another purpose
  bool show_in_terminal = false;  // output of show(s): stdout is a terminal; else to files
  bool only_verdicts = false;     // print is silent, and no movie is made
  bool no_pictures = false;       // nor is a picture or a record
  // A PNG of the last state of the last simulation; "": none.
  std::filesystem::path last_picture;
  std::optional<double> sample_at;  // s, of every simulation; see Run::sample_at
  bool trust = false;               // all of Lua's library, files everywhere
  std::filesystem::path program;    // hackle, which studies run; empty: they are refused
  std::size_t lua_memory = default_lua_memory;  // bytes, limit of Lua values
  // bytes, limit of movies and records of one simulation
  double output_limit = default_output_limit;
};

// An expectation of the script. `settle` is called at its end, if not empty.
struct OpenExpectation {
  Expectation expectation;
  std::function<Expectation()> settle;
};

class Session {
 public:
  explicit Session(ConsoleSettings settings);
  ~Session();

  // Returns the path of an output file that the script names: below the output folder unless the
  // name is absolute. Throws Error (refused), naming `who`, unless a script may write there; see
  // Sandbox.
  std::filesystem::path output_path(const std::string& who, const std::filesystem::path& name);
  // Returns the path of an input file: a file named on the command line is relative to the current
  // folder; any other lies beside the script or, if it does not exist there, in the output folder.
  // Throws Error (refused) unless a script may read it.
  std::filesystem::path input_path(const std::string& who, const std::filesystem::path& name) const;
  // Returns the same for a file written earlier by the script: in the output folder.
  std::filesystem::path written_path(const std::string& who,
                                     const std::filesystem::path& name) const;
  // Whether another rank runs this script too, and writes its files.
  bool follows() const {
    return settings.execution.ranks != nullptr && !settings.execution.ranks->leads();
  }
  // Returns output_path() for a file that `who` is about to write: refuses a wrong extension, a
  // path that cannot be written, and a file that somebody else is writing.
  std::filesystem::path claim(const std::string& who, const std::filesystem::path& name,
                              FileKind kind);
  // Calls `write` for the path of a picture, in a folder that exists, unless the script is only
  // checked. Returns the path.
  std::filesystem::path write_picture(
      const std::string& who, const std::filesystem::path& name,
      const std::function<void(const std::filesystem::path&)>& write);
  // Returns the folder of the script; at the prompt "", the current folder.
  std::filesystem::path script_folder() const;
  Sandbox sandbox() const;

  // Throws what Run throws.
  std::shared_ptr<Run> simulate(Plate plate, Numerics numerics);
  // Returns a run that goes on from a checkpoint. Throws what read_checkpoint and resume throw.
  std::shared_ptr<Run> resume(const std::filesystem::path& path);
  // Adds a run that was made from another.
  std::shared_ptr<Run> adopt(std::shared_ptr<Run> run);
  // Opens a run file. Throws what Recording throws.
  std::shared_ptr<Recording> open_recording(const std::filesystem::path& path);
  // Returns the bytes that one more simulation may take: those available at the start of the
  // session minus those of its simulations and recordings, whether touched yet or not.
  std::uint64_t memory_left() const;
  // Throws Error (run_failed), whose message begins with `who`, unless that many bytes are left.
  void check_memory(const std::string& who, std::uint64_t bytes) const;
  // Simulations are numbered from 1 in the order they were made.
  int number_of(const Run& run) const;
  // Closes a run that can no longer be reached and keeps only its summary. A failure is kept for
  // close_all().
  void retire(const Run* run) noexcept;
  // From now on the script keeps checkpoints. If its folder has an unfinished run of the same
  // script with the same inputs, goes on with that, and says so. Throws Error (files) if another
  // program is at work there, Error (refused) if the run cannot be continued.
  void begin_checkpoints();
  // Goes on with what was found; before the script is run. Throws Error (refused).
  void continue_from(Found found);
  // Closes every run. Throws Error with every problem of closing them.
  void close_all();
  // Returns the summaries of all simulations, in the order they were made.
  std::vector<Summary> summaries() const;
  // Returns the same for a script that is only checked.
  std::vector<Rehearsal> rehearsals() const;

  // Returns whether a background run is unfinished and not paused.
  bool is_working() const;
  // Lets it run for about this many seconds of wall time. Returns the numbers of the runs that have
  // finished. Throws the Error of a failed run.
  std::vector<int> work(double seconds);
  // Finishes all background runs, paused or not; shows progress.
  void finish_work();
  void pause_work();

  // Called before and after a line of the prompt is run, for the transcript.
  void begin_line(const Transcript::Chunk& chunk);
  void end_line(const Transcript::Chunk& chunk, Transcript::Outcome outcome);
  // Returns everything typed so far, as a script; for a running script, that script.
  std::string script() const;

  // Returns whether a person types lines.
  bool has_prompt() const { return has_prompt_; }
  // Gives the expectations that wait for the end of the script their numbers.
  void settle_expectations();

  // Returns the library, which is read on first use. Throws Error (files).
  const Materials& materials();

  // Ends the script without failure, by throwing.
  [[noreturn]] void leave(int code);

  // Throws Error (refused) if --set was given but no options { ... } used it.
  void check_overrides_used() const;

  ConsoleSettings settings;
  Origin origin;
  std::vector<std::string> arguments;                   // of the command line, for the script
  std::map<std::string, std::string> declared_options;  // with their defaults, from options { ... }
  std::optional<int> exit_code;                         // from os.exit
  MakeRoom make_room;  // called before anything is printed; may be empty
  std::function<std::string(lua_State*)> help_on;  // see help.hpp, set by the console
  std::shared_ptr<OutputNames> names = std::make_shared<OutputNames>();  // of output files
  std::optional<OutputFolder> folder;  // of a script that is run; taken with its first file
  std::int64_t said = 0;               // lines printed by the prompt and the script so far
  int pictures_shown = 0;              // as files, by show(s)
  std::unordered_map<const Plate*, PlateMemory> plates;  // memory of the script's plates
  std::unique_ptr<ScriptCheckpoints> checkpoints;        // of a script that is run
  std::vector<OpenExpectation> expectations;             // in the order they were said
  ReplayHost objects;  // what the console knows of them: run_at, name and push_empty

 private:
  void take_folder();
  std::optional<Found> find_unfinished();
  std::optional<Found> found_by_first(std::optional<Found> found) const;
  std::filesystem::path leading_folder() const;
  ScriptHost script_host();
  Run* run_of(int number) const;
  std::shared_ptr<Run> begin(std::shared_ptr<Run> run);

  struct Entry {
    std::shared_ptr<Run> run;  // null once retired
    std::optional<Summary> summary;
    std::optional<Rehearsal> rehearsal;
    std::int64_t noted_step = 0;  // last step in the transcript
    bool has_failed = false;      // since then, in the background
  };
  void close(Run& run) noexcept;
  void paint_last(Run& run);
  std::vector<std::shared_ptr<Run>> open_runs() const;

  const std::uint64_t memory_at_start_;
  std::vector<Entry> entries_;
  std::vector<std::weak_ptr<const Recording>> recordings_;
  Transcript transcript_;
  bool has_prompt_ = false;
  int painted_ = 0;  // the number of the run that the last picture shows
  std::vector<Problem> closing_problems_;
  ErrorKind closing_kind_ = ErrorKind::files;
  std::optional<Materials> materials_;
  std::optional<CallWatch> call_watch_;           // of several ranks
  mutable std::filesystem::path leading_folder_;  // known to those that follow
};

}  // namespace hackle
