// SPDX-License-Identifier: MIT
// The scene language, ready to run scripts.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "console/prompt/completion.hpp"
#include "console/prompt/idle.hpp"
#include "console/session.hpp"

namespace hackle {

class Console {
 public:
  explicit Console(ConsoleSettings settings);
  ~Console();

  // Runs a script with `arguments` in `arg` and `...`. However it ends, every simulation it made is
  // closed, so that its files are complete. Throws Error: files (it cannot be read), script (syntax
  // or run-time error of Lua), or the kind of what a function of ours has thrown; the problems of
  // closing come after it.
  void run_file(const std::filesystem::path& path, const std::vector<std::string>& arguments = {});
  // The same with the text of a script.
  void run_text(const std::string& text, const std::string& name,
                const std::vector<std::string>& arguments = {});

  // For the prompt. Whether more lines are needed to make sense of the text.
  bool is_incomplete(const std::string& text) const;
  // What may come next, see completion.hpp. Nothing of the script runs. Throws Error.
  Completion complete(const std::string& text) const;
  // Runs an expression or statements; the values it gives, as text (see value_text.hpp). The first
  // of them, if it is not nil, is then `_`. Closes nothing. Throws Error.
  std::vector<std::string> evaluate(const std::string& text);

  // Whether a run that was started in the background wants to go on; lets it do so for about so
  // many seconds. What a script prints meanwhile comes after make_room(). Returns what a person
  // should know: which have arrived. Throws the Error of one that has failed.
  bool is_working() const;
  std::vector<std::string> work(double seconds, const MakeRoom& make_room);
  // What was started stands still; or arrives, with its progress shown.
  void pause_work();
  void finish_work();

  // Closes every simulation. Throws Error when a file could not be completed.
  void close_all();

  // Of every simulation so far, in the order they were made.
  std::vector<Summary> simulations() const;
  // The same, of a script that is checked.
  std::vector<Rehearsal> rehearsals() const;
  // Name and default of what the script has declared with options { ... } so far.
  const std::map<std::string, std::string>& options() const;
  // What the script gave to os.exit.
  std::optional<int> exit_code() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
