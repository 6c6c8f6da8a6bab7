// SPDX-License-Identifier: MIT
// Records what was typed at the prompt, as a script that repeats it to the bit.
#pragma once

#include <cstdint>
#include <string>

namespace hackle {

class Transcript {
 public:
  // One line, or several that form a chunk.
  struct Chunk {
    std::string text;
    bool is_expression = false;  // valid after `return`
    bool is_statement = true;    // a call is both
  };
  enum class Outcome { nothing, value, failed, interrupted };

  void typed(const Chunk& chunk, Outcome outcome);
  // Notes that before the next line a simulation (the `number`-th made) had run in the background
  // to this step and time (s); it may have failed there.
  void went_on(int number, std::int64_t step, double time, bool failed);
  // Notes that its run in the next typed line is interrupted after this step.
  void interrupted(int number, std::int64_t step);

  const std::string& text() const { return text_; }

 private:
  void add(const std::string& line) { text_ += line + "\n"; }

  std::string text_;
  bool run_is_interrupted_ = false;
};

}  // namespace hackle
