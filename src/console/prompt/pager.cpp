// SPDX-License-Identifier: MIT
#include "console/prompt/pager.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "base/streams.hpp"
#include "base/terminal.hpp"
#include "base/text.hpp"

namespace hackle {
namespace {

std::size_t terminal_rows() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 2 ? size.ws_row : 24;
}

bool is_typed_ahead() {
  int waiting = 0;
  return ioctl(STDIN_FILENO, FIONREAD, &waiting) == 0 && waiting > 0;
}

// While it lives, keys arrive one by one and are not shown, Ctrl-C too.
class SingleKeys {
 public:
  SingleKeys() : valid_(tcgetattr(STDIN_FILENO, &before_) == 0) {
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
    raw.c_cc[VMIN] = 1;
    raw.c_cc[VTIME] = 0;
    if (valid_) tcsetattr(STDIN_FILENO, TCSADRAIN, &raw);
  }
  ~SingleKeys() {
    if (valid_) tcsetattr(STDIN_FILENO, TCSADRAIN, &before_);
  }
  SingleKeys(const SingleKeys&) = delete;
  SingleKeys& operator=(const SingleKeys&) = delete;

 private:
  termios before_{};
  bool valid_;
};

// Waits for a key; returns whether the text is to go on.
bool asked_for_more(std::size_t shown, std::size_t all) {
  print_out("\033[7m{} of {} lines: space for more, q to end\033[0m", shown, all);
  flush(stdout);
  char key[8] = {};  // a key of the keypad is several bytes
  ssize_t count = 0;
  {
    const SingleKeys keys;
    count = read(STDIN_FILENO, key, sizeof key);
  }
  print_out("\r\033[K");
  const std::string_view pressed(key, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return pressed == " " || pressed == "\n" || pressed == "\r" || pressed == "\033[B" ||
         pressed == "\033OB";
}

// A line longer than the screen is wide takes several rows of it.
std::size_t rows_of(const std::string& line, std::size_t columns) {
  return 1 + (line.empty() ? 0 : line.size() - 1) / columns;
}

}  // namespace

void show_in_pages(const std::string& text) {
  const std::size_t columns = terminal_columns(STDOUT_FILENO), room = terminal_rows() - 2;
  std::vector<std::string> lines;
  std::istringstream source(fitted(text, columns));
  for (std::string line; std::getline(source, line);) lines.push_back(line);
  std::size_t rows = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (rows + rows_of(lines[k], columns) > room && !is_typed_ahead()) {
      if (!asked_for_more(k, lines.size())) break;
      rows = 0;
    }
    print_out("{}\n", lines[k]);
    rows += rows_of(lines[k], columns);
  }
  flush(stdout);
}

}  // namespace hackle
