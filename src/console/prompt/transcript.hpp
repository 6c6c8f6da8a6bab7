// SPDX-License-Identifier: MIT
// What was typed at the prompt, as a script that does the same again, to the bit.
#pragma once

#include <cstdint>
#include <string>

namespace hackle {

class Transcript {
 public:
  // A line, or several that belong together.
  struct Chunk {
    std::string text;
    bool is_expression = false;  // what follows a return
    bool is_statement = true;    // a call is both
  };
  enum class Outcome { nothing, value, failed, interrupted };

  void typed(const Chunk& chunk, Outcome outcome);
  // Before the next line a simulation, the number-th that was made, had gone on beside the prompt
  // to this step and time, s; it may have failed there.
  void went_on(int number, std::int64_t step, double time, bool failed);
  // In the next line that is typed its run is interrupted after this step.
  void interrupted(int number, std::int64_t step);

  const std::string& text() const { return text_; }

 private:
  void add(const std::string& line) { text_ += line + "\n"; }

  std::string text_;
  bool run_is_interrupted_ = false;
};

}  // namespace hackle
