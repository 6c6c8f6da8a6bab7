// SPDX-License-Identifier: MIT
// The prompt: reads what a person types, runs it and shows what it gives, as lua does.
#pragma once

#include <functional>
#include <string>

#include "base/error.hpp"
#include "console/console.hpp"
#include "console/prompt/line_editor.hpp"

namespace hackle {

class Prompt {
 public:
  // Where lines come from: shows the prompt and has `idle` work while it waits.
  using Reader =
      std::function<LineEnd(const std::string& prompt, std::string& line, const Idle& idle)>;
  // What becomes of values, errors and advice.
  struct Voice {
    std::function<void(const std::string&)> value;
    std::function<void(const Error&)> error;
    std::function<void(const std::string&)> note;
  };

  Prompt(Console& console, Reader reader, Voice voice);

  // Until the input ends or a line calls os.exit. Returns the code of os.exit, or else that of the
  // first error, or 0.
  int run();
  // The lines before the one that is being read, of the same chunk; each with its end.
  const std::string& begun() const { return begun_; }

 private:
  bool read_chunk(std::string& chunk);
  void evaluate(const std::string& chunk);
  bool work(const MakeRoom& make_room);
  void pause_work();
  void tell(const Error& error);
  void explain_local(const std::string& chunk);

  Console& console_;
  Reader reader_;
  Voice voice_;
  std::string begun_;
  int first_code_ = 0;
  bool local_is_explained_ = false;
};

}  // namespace hackle
