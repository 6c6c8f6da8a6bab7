// SPDX-License-Identifier: MIT
// The ranks that a launcher of MPI started: every one runs the script, the first one alone talks to
// people and writes their files. This is the only place that decides so.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/ranks/ranks.hpp"
#include "console/console.hpp"

namespace hackle {

class Company {
 public:
  // Of a program that is alone, `ranks` is nullptr. A rank that follows says nothing from now on:
  // its stdout is closed, its stderr is kept for leave().
  explicit Company(Ranks* ranks);
  // Removes the folder of a rank that follows.
  ~Company();
  Company(const Company&) = delete;
  Company& operator=(const Company&) = delete;

  Ranks* ranks() const { return ranks_; }
  bool follows() const { return ranks_ != nullptr && !ranks_->leads(); }

  // Changes what a script is called with. A rank that follows makes no movie, picture, record or
  // report, and what else the script writes goes to a folder of its own, which nobody keeps.
  void join(ConsoleSettings& settings) const;

  // The end of the program, with its exit code. A rank that ends with an error while others go on
  // ends them too, and says why.
  int leave(int code) const;

 private:
  void remove_folder() const;

  Ranks* ranks_;
  std::filesystem::path folder_;  // of a rank that follows
  int said_ = -1;                 // the descriptor of what it would have said
};

}  // namespace hackle
