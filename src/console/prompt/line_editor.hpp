// SPDX-License-Identifier: MIT
// Reads lines from a person at a terminal, with editing and history by libedit.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "console/prompt/completion.hpp"
#include "console/prompt/idle.hpp"

namespace hackle {

enum class LineEnd { entered, cleared, end_of_input };

class LineEditor {
 public:
  // Reads the history from `history` and keeps it there; failure to do so is no error.
  explicit LineEditor(std::filesystem::path history);
  ~LineEditor();

  // Offers completions for Tab, given the line before the cursor; without it there are none. If it
  // throws Error, the terminal beeps.
  using Completer = std::function<Completion(const std::string& before)>;
  void complete_with(Completer complete);

  // Reads one line without its end. `cleared`: Ctrl-C was pressed on the content of `line`;
  // `end_of_input`: Ctrl-D on an empty line, or the terminal is gone. Calls `idle` between keys;
  // its exceptions pass through, and the line is lost.
  LineEnd read(const std::string& prompt, std::string& line, const Idle& idle);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// Returns $XDG_STATE_HOME/hackle/history, by default below ~/.local/state; "" without a home
// folder.
std::filesystem::path history_file();

}  // namespace hackle
