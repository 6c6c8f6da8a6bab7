// SPDX-License-Identifier: MIT
// Messages of the program to the user, on stderr.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "output/report/summary.hpp"

namespace hackle {

// Returns "error: what (remedy)" for each problem, with "error:" on every line. In colour "error:"
// is red, the problem bold and the remedy faint. Lines longer than `columns` are broken at blanks,
// with the remedy on a line of its own; 0 breaks none.
std::string error_text(const Error& error, bool colour, std::size_t columns = 0);

// Prints the same on stderr, in colour on a terminal unless NO_COLOR is set.
void tell(const Error& error);

// Prints "wrote a.png (16.3 kB)" on stderr.
void tell_file(const std::filesystem::path& file);

// Prints "wrote out/a.mp4 (1.2 MB)" once for each file of the simulations, and what can be done
// with a recording.
void tell_files(const std::vector<Summary>& simulations);

// Returns a text from a file, safe to print on a terminal: without control characters.
std::string printable(std::string text);

// Returns how much to report, given the terminal and the user's wish.
Talk talk(bool quiet);

}  // namespace hackle
