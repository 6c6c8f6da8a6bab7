// SPDX-License-Identifier: MIT
// Reads lines of stdin without a prompt, from a file or another program.
#pragma once

#include <string>

#include "console/prompt/idle.hpp"
#include "console/prompt/line_editor.hpp"

namespace hackle {

class LineReader {
 public:
  // Calls `idle` while no line is available.
  LineEnd read(std::string& line, const Idle& idle);

 private:
  bool fill();

  // Not that of a stream: lines that a stream has read ahead would seem not to be there.
  std::string buffer_;
};

}  // namespace hackle
