// SPDX-License-Identifier: MIT
#include "base/terminal.hpp"

#include <string>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/streams.hpp"
#include "base/text.hpp"

namespace hackle {

std::size_t terminal_columns(int descriptor) {
  winsize size{};
  const bool known = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

void say_note(std::string_view text) {
  const std::string line = fmt::format("note: {}", text);
  const bool seen = isatty(STDERR_FILENO) != 0;
  say("{}\n", seen ? fitted(line, terminal_columns(STDERR_FILENO)) : line);
}

}  // namespace hackle
