// SPDX-License-Identifier: MIT
// Watches that the ranks of a plate, each of which runs the script, make the same calls: a clock, a
// file or chance may lead one astray.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "base/ranks/ranks.hpp"

namespace hackle {

class CallWatch {
 public:
  explicit CallWatch(Ranks& ranks) : ranks_(ranks) {}

  // Notes a call of this rank, such as "run(1e-05)"; `values` are all that it was given, in bytes.
  void note(std::string call, const std::string& values);
  // Compares the calls of all ranks so far; each comes here before what they do together. Throws
  // Error (run_failed), which names the first call that differs, on all of them.
  void compare();

 private:
  struct Call {
    std::string text;
    std::uint64_t digest = 0;  // of all calls up to this one
  };
  std::string text_of(std::uint64_t call) const;
  [[noreturn]] void tell();

  Ranks& ranks_;
  std::uint64_t count_ = 0;
  std::deque<Call> last_;
};

}  // namespace hackle
