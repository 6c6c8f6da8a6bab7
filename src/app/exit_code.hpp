// SPDX-License-Identifier: MIT
// The exit codes of the program: 0 ok, 1 run failed, 2 usage, 3 script error, 4 refused input, 5
// files, 130 interrupted.
#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace hackle {

struct ExitCode {
  int number;
  std::string_view meaning;
};

// Returns all of them, in order.
std::span<const ExitCode> exit_codes();

// Returns the result of `work`, or the code of the Error it threw, which is printed on stderr. Any
// other exception counts as a failed run.
int exit_code_of(const std::function<int()>& work);

}  // namespace hackle
