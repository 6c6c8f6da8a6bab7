// SPDX-License-Identifier: MIT
// Lines from a person at a terminal: editing and history with libedit.
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
  // The history is read from and kept in `history`; a file that cannot be is no error.
  explicit LineEditor(std::filesystem::path history);
  ~LineEditor();

  // What Tab offers, given the line before the cursor; without it nothing. An Error that it throws
  // is a beep.
  using Completer = std::function<Completion(const std::string& before)>;
  void complete_with(Completer complete);

  // One line without its end. `cleared`: Ctrl-C was pressed on what `line` then has;
  // `end_of_input`: Ctrl-D on an empty line, or the terminal is gone. Between keys `idle` has its
  // turn; what
  // it throws comes out here, the line being lost.
  LineEnd read(const std::string& prompt, std::string& line, const Idle& idle);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// $XDG_STATE_HOME/hackle/history, by default below ~/.local/state; "" without a home.
std::filesystem::path history_file();

}  // namespace hackle
