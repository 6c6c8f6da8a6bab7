// SPDX-License-Identifier: MIT
// Lines of stdin without any prompt: of a file or of another program.
#pragma once

#include <string>

#include "console/prompt/idle.hpp"
#include "console/prompt/line_editor.hpp"

namespace hackle {

class LineReader {
 public:
  // Does what is to be done while no line is there.
  LineEnd read(std::string& line, const Idle& idle);

 private:
  bool fill();

  // Not a stream's: what a stream has read ahead would look as if nothing were there.
  std::string buffer_;
};

}  // namespace hackle
