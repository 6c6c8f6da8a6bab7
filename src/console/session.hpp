// SPDX-License-Identifier: MIT
// What the functions of a script share: how it was called, and the simulations it made.
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
#include "output/output_names.hpp"
#include "output/run.hpp"
#include "store/recording.hpp"

struct lua_State;

namespace hackle {

// What a script is run for: its results, to see whether it makes sense and what it would take, or
// to learn which options it has.
enum class Purpose { results, check, options };

struct ConsoleSettings {
  Purpose purpose = Purpose::results;
  std::filesystem::path output_folder;           // "": out/<name of the script>
  std::map<std::string, std::string> overrides;  // --set key=value
  Execution execution;
  Talk talk = Talk::plain;
  bool print_to_stderr = false;   // what the script prints: stdout is for something else
  bool show_in_terminal = false;  // what show(s) draws: stdout is a terminal; else in files
  bool trust = false;             // all of Lua's library, files everywhere
  std::size_t lua_memory = default_lua_memory;  // bytes, of the values of Lua
  double output_limit = default_output_limit;   // bytes, of movies and records of one simulation
};

class Session {
 public:
  explicit Session(ConsoleSettings settings);
  ~Session();

  // Where a file that the script names goes: below the output folder unless the name is absolute.
  // Throws Error (refused), saying `who` asks, unless a script may write there; see Sandbox.
  std::filesystem::path output_path(const std::string& who,
                                    const std::filesystem::path& name) const;
  // Where one is read: a file that the command line names is meant from the current folder; any
  // other lies beside the script or, if there is none, in the output folder. Throws Error (refused)
  // unless a script may read it.
  std::filesystem::path input_path(const std::string& who, const std::filesystem::path& name) const;
  // The same for a file that the script has written before: in the output folder.
  std::filesystem::path written_path(const std::string& who,
                                     const std::filesystem::path& name) const;
  // The same as output_path(), for a file that `who` is going to write now: refuses a wrong ending,
  // what cannot be written, and what somebody else writes.
  std::filesystem::path claim(const std::string& who, const std::filesystem::path& name,
                              FileKind kind);
  // Writes a picture that is made last, unless the script is only checked. Returns where.
  std::filesystem::path write_picture(const std::string& who, const std::filesystem::path& name,
                                      const std::function<Image()>& make);
  // Of the script, or "" at the prompt: the current one.
  std::filesystem::path script_folder() const;
  Sandbox sandbox() const;

  // Throws what Run throws.
  std::shared_ptr<Run> simulate(Plate plate, Numerics numerics);
  // Takes on a run made from another.
  std::shared_ptr<Run> adopt(std::shared_ptr<Run> run);
  // Opens a run file. Throws what Recording throws.
  std::shared_ptr<Recording> open_recording(const std::filesystem::path& path);
  // Bytes that one more simulation may take: those that were available when the session began less
  // what its simulations and recordings hold, whether they have touched it yet or not.
  std::uint64_t memory_left() const;
  // Throws Error (run_failed), which `who` begins, unless so many are left.
  void check_memory(const std::string& who, std::uint64_t bytes) const;
  // Simulations count from 1 in the order they were made.
  int number_of(const Run& run) const;
  // Closes a run that nobody can reach any more and keeps its summary alone. A failure is kept for
  // close_all().
  void retire(const Run* run) noexcept;
  // Closes every run. Throws Error with every problem there was in closing any of them.
  void close_all();
  // Of every simulation, in the order they were made.
  std::vector<Summary> summaries() const;
  // The same for a script that is checked.
  std::vector<Rehearsal> rehearsals() const;

  // Whether anything that runs beside the prompt is under way and not paused.
  bool is_working() const;
  // Lets it go on for about so many seconds of wall time. Returns the numbers of those that have
  // arrived. Throws the Error of one that has failed.
  std::vector<int> work(double seconds);
  // Lets everything arrive, paused or not; shows progress.
  void finish_work();
  void pause_work();

  // Before and after a line of the prompt is carried out, for the transcript.
  void begin_line(const Transcript::Chunk& chunk);
  void end_line(const Transcript::Chunk& chunk, Transcript::Outcome outcome);
  // What was typed so far, to be typed no more; of a script that runs, the script.
  std::string script() const;

  // The library, read when first asked for. Throws Error (files).
  const Materials& materials();

  // Ends the script, which is no failure: throws.
  [[noreturn]] void leave(int code);

  // Throws Error (refused) when --set was given and no options { ... } took it.
  void check_overrides_used() const;

  ConsoleSettings settings;
  Origin origin;
  std::vector<std::string> arguments;                   // of the command line, for the script
  std::map<std::string, std::string> declared_options;  // and their defaults, by options { ... }
  std::optional<int> exit_code;                         // asked for with os.exit
  MakeRoom make_room;                                   // before anything is printed, or none
  std::function<std::string(lua_State*)> help_on;       // see help.hpp, set by the console
  std::shared_ptr<OutputNames> names = std::make_shared<OutputNames>();  // of what is written
  std::int64_t said = 0;   // lines of the prompt and of the script so far
  int pictures_shown = 0;  // in files, by show(s)
  std::unordered_map<const Plate*, PlateMemory> plates;  // what those of the script take

 private:
  struct Entry {
    std::shared_ptr<Run> run;  // null once retired
    std::optional<Summary> summary;
    std::optional<Rehearsal> rehearsal;
    std::int64_t noted_step = 0;  // the transcript has come this far
    bool has_failed = false;      // since then, beside the prompt
  };
  void close(Run& run) noexcept;
  std::vector<std::shared_ptr<Run>> open_runs() const;

  const std::uint64_t memory_at_start_;
  std::vector<Entry> entries_;
  std::vector<std::weak_ptr<const Recording>> recordings_;
  Transcript transcript_;
  bool has_prompt_ = false;
  std::vector<Problem> closing_problems_;
  ErrorKind closing_kind_ = ErrorKind::files;
  std::optional<Materials> materials_;
};

}  // namespace hackle
