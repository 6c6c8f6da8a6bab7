// SPDX-License-Identifier: MIT
// stdin, stdout and stderr, which may be closed, full, or a pipe that nobody reads: a run never
// fails because its messages cannot be written.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace hackle {

// Call this before any file is opened. It opens closed descriptors 0 to 2, so that no file of a run
// gets one of those numbers; writing to them still fails. Afterwards a stdout pipe that loses its
// reader counts as an interrupt (interrupt.hpp), and no other pipe ends the process.
void hold_standard_streams();

// Writes as much as the stream accepts; never throws.
void write_to(std::FILE* stream, std::string_view text) noexcept;
void flush(std::FILE* stream) noexcept;

// Prints to stdout.
template <class... Values>
void print_out(fmt::format_string<Values...> pattern, Values&&... values) {
  write_to(stdout, fmt::format(pattern, std::forward<Values>(values)...));
}
// Prints to stderr.
template <class... Values>
void say(fmt::format_string<Values...> pattern, Values&&... values) {
  write_to(stderr, fmt::format(pattern, std::forward<Values>(values)...));
}

// Flushes stdout. Returns why some earlier output was lost, or nothing if all of it was written.
std::optional<std::string> lost_output() noexcept;
// Returns whether output was lost because its reader is gone.
bool output_is_unread() noexcept;

}  // namespace hackle
