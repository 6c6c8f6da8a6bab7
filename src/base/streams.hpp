// SPDX-License-Identifier: MIT
// stdin, stdout and stderr, which may be closed, full, or a pipe that nobody reads: a run never
// fails for want of somebody to talk to.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace hackle {

// To be called before any file is opened. Descriptors 0 to 2 that are closed are opened, so that no
// file of a run becomes one of them; what is written to them still fails. A pipe behind stdout that
// loses its reader is an interrupt from now on (interrupt.hpp), and no other pipe ends the process.
void hold_standard_streams();

// Writes as much as the stream takes; never throws.
void write_to(std::FILE* stream, std::string_view text) noexcept;
void flush(std::FILE* stream) noexcept;

// To stdout.
template <class... Values>
void print_out(fmt::format_string<Values...> pattern, Values&&... values) {
  write_to(stdout, fmt::format(pattern, std::forward<Values>(values)...));
}
// To stderr.
template <class... Values>
void say(fmt::format_string<Values...> pattern, Values&&... values) {
  write_to(stderr, fmt::format(pattern, std::forward<Values>(values)...));
}

// Flushes stdout. Why something that was printed so far never got anywhere, or nothing if all did.
std::optional<std::string> lost_output() noexcept;
// Whether it was lost because nobody reads it any more.
bool output_is_unread() noexcept;

}  // namespace hackle
