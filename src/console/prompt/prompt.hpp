// SPDX-License-Identifier: MIT
// The prompt: reads typed lines, runs them and shows their values, like lua does.
#pragma once

#include <functional>
#include <string>

#include "base/error.hpp"
#include "console/console.hpp"
#include "console/prompt/line_editor.hpp"

namespace hackle {

class Prompt {
 public:
  // The source of lines: shows the prompt and calls `idle` while it waits.
  using Reader =
      std::function<LineEnd(const std::string& prompt, std::string& line, const Idle& idle)>;
  // The outlets for values, errors and advice.
  struct Voice {
    std::function<void(const std::string&)> value;
    std::function<void(const Error&)> error;
    std::function<void(const std::string&)> note;
  };

  Prompt(Console& console, Reader reader, Voice voice);

  // Runs until the input ends or a line calls os.exit. Returns the code of os.exit, else that of
  // the first error, or 0.
  int run();
  // Returns the earlier lines of the present chunk, each with its end.
  const std::string& begun() const { return begun_; }

 private:
  bool read_chunk(std::string& chunk);
  void evaluate(const std::string& chunk);
  bool work(const MakeRoom& make_room);
  void pause_work();
  void tell(const Error& error);

  Console& console_;
  Reader reader_;
  Voice voice_;
  std::string begun_;
  int first_code_ = 0;
};

}  // namespace hackle
