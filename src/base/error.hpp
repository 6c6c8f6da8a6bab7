// SPDX-License-Identifier: MIT
// The only error type of Hackle: it says what is wrong, where, and what to do about it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace hackle {

// The kind of an error. Its number is the exit code of the program.
enum class ErrorKind {
  run_failed = 1,     // the computation went wrong (divergence, out of memory, encoder failure)
  usage = 2,          // the command line
  script = 3,         // Lua syntax or run-time error
  refused = 4,        // input that makes no physical or numerical sense
  files = 5,          // reading or writing
  interrupted = 130,  // Ctrl-C
};

// One thing that is wrong. `remedy` tells the user what to do; it may be empty.
struct Problem {
  std::string what;
  std::string remedy;
};

// Carries at least one problem. what() has one line per problem: "what (remedy)".
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string what, std::string remedy = {});
  Error(ErrorKind kind, std::vector<Problem> problems);

  ErrorKind kind() const { return kind_; }
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  ErrorKind kind_;
  std::vector<Problem> problems_;
};

// Collects all problems of one check, so that the user sees all of them at once.
class Problems {
 public:
  void add(std::string what, std::string remedy = {});
  bool empty() const { return list_.empty(); }
  const std::vector<Problem>& list() const { return list_; }
  // Throws Error of this kind if a problem was added.
  void throw_if_any(ErrorKind kind = ErrorKind::refused) const;

 private:
  std::vector<Problem> list_;
};

}  // namespace hackle
