// SPDX-License-Identifier: MIT
// The scene language, ready to run scripts.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "console/prompt/completion.hpp"
#include "console/prompt/idle.hpp"
#include "console/session.hpp"

namespace hackle {

// What becomes of the simulations of a script at its end. Where the prompt goes on with them, it
// goes on with the locals at the top of the script too (see kept_locals.hpp).
enum class Ending { close, go_on };

class Console {
 public:
  explicit Console(ConsoleSettings settings);
  ~Console();

  // Runs a script with `arguments` in `arg` and `...`. However it ends, every simulation it made is
  // closed, so that its files are complete, unless the prompt goes on with them. Throws Error:
  // files (it cannot be read), script (syntax or run-time error of Lua), or the kind of the error
  // that a bound function threw; problems of closing are added to it.
  void run_file(const std::filesystem::path& path, const std::vector<std::string>& arguments = {},
                Ending ending = Ending::close);
  // Goes on with a script that was stopped, from its checkpoint: with the file of its name or,
  // where that does not exist, its text as it was. The settings are those of its first life. Throws
  // the same, and Error (refused) where it does something else than it did.
  void run_on(Found found, Ending ending = Ending::close);
  // Runs the text of a script likewise.
  void run_text(const std::string& text, const std::string& name,
                const std::vector<std::string>& arguments = {}, Ending ending = Ending::close);

  // For the prompt: shows long texts to a person in pages.
  void page_with(std::function<void(const std::string&)> page);
  // Returns whether the text needs more lines to be complete.
  bool is_incomplete(const std::string& text) const;
  // Completes the text, see completion.hpp. Runs nothing of the script. Throws Error.
  Completion complete(const std::string& text) const;
  // Runs an expression or statements and returns the values as text (see value_text.hpp). The first
  // value, if not nil, is stored in `_`. Closes nothing. Throws Error.
  std::vector<std::string> evaluate(const std::string& text);

  // Returns whether a background run has work left; work() lets it run for about that many seconds.
  // Output of a script comes after make_room(). Returns messages for the user: which runs have
  // finished. Throws the Error of a failed run.
  bool is_working() const;
  std::vector<std::string> work(double seconds, const MakeRoom& make_room);
  // Pauses background runs, or finishes them with their progress shown.
  void pause_work();
  void finish_work();

  // Closes every simulation. Throws Error if a file could not be completed.
  void close_all();

  // Returns the summaries of all simulations so far, in the order they were made.
  std::vector<Summary> simulations() const;
  // Returns the same for a script that is only checked.
  std::vector<Rehearsal> rehearsals() const;
  // Returns the expectations of the script, in the order they were said.
  std::vector<Expectation> expectations() const;
  // Returns names and defaults that the script has declared with options { ... } so far.
  const std::map<std::string, std::string>& options() const;
  // Returns the exit code that the script gave to os.exit.
  std::optional<int> exit_code() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
