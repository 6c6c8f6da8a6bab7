// SPDX-License-Identifier: MIT
// Counts the instructions of a program, which no other process disturbs, with valgrind.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hackle {

// Returns the path of valgrind, or nothing if it is not on the PATH.
std::optional<std::filesystem::path> find_valgrind();

// Returns the number that callgrind reports: "Collected : 123".
std::optional<double> collected_in(std::string_view report);

// Runs the words under callgrind and returns the instructions of the whole program; nothing if it
// fails. Throws Error (interrupted).
std::optional<double> count_instructions(const std::filesystem::path& valgrind,
                                         std::vector<std::string> words);

}  // namespace hackle
