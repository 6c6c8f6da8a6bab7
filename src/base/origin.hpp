// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hackle {

// The script that made a run or a movie.
struct Origin {
  std::string script_name;  // "" at the prompt
  std::string script_text;
};

}  // namespace hackle
